// SPDX-License-Identifier: Apache-2.0
// Thin things that enclose nothing: a mast, a wire, a whisker.
#pragma once

#include <vector>

#include "tactics/image.h"
#include "tactics/region_tree.h"

namespace tactics {

/// Runs along the arcs of a tree, at least `shortest` pixels long, on which the picture differs from both sides in the same way:
/// the two edges of something so thin that the map, not thinned, has one ridge for both. Where the arcs go on they lead on, no
/// farther than that again. `lab`: CIELAB of each pixel, a plane each.
std::vector<RegionLine> thin_things_of(const RegionTree& tree, const EdgeMap& map, const std::vector<std::vector<float>>& lab,
                                       double shortest);

}  // namespace tactics
