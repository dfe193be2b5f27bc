// SPDX-License-Identifier: Apache-2.0
// From a picture and its contour maps to regions that nest.
#pragma once

#include <cstdint>
#include <vector>

#include "filters/contour_maps.h"
#include "filters/region_merging.h"
#include "tactics/image.h"
#include "tactics/region_tree.h"

namespace tactics {

/// Basins of the fine map, the arcs between them with their strengths, and the merging. `picture` (grey or colour) and the maps
/// have one size. `least`: square pixels, what is smaller is no region of its own.
RegionTree region_tree_of(const Image& picture, const ContourMaps& maps, double least, const PairWeights& weights,
                          const PairWatcher& watcher = {});

/// The same from given faces: the regions of one picture as another one judges them.
RegionTree region_tree_on(std::vector<std::uint32_t> face, const Image& picture, const ContourMaps& maps, double least,
                          const PairWeights& weights, const PairWatcher& watcher = {});

/// The weights of the features in merging, fitted for each kind of map (filters/net/train/fit.py).
const PairWeights& pair_weights(bool learned);

}  // namespace tactics
