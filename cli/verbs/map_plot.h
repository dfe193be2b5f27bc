// SPDX-License-Identifier: Apache-2.0
// Heights in mm as a plot, for the words and charts of a relief or a model.
#pragma once

#include "tactics/plot.h"
#include "tactics/relief/heightmap.h"

namespace tactics {

inline constexpr int kMostSamples = 250;  ///< along the longer side: more than a chart or a word shows

/// Axes in mm, x to the right, y upwards and the height, and the surface of the map with at most that many samples along its
/// longer side; no surface if the map has fewer than two rows or columns.
Plot plot_of_map(const HeightMap& map, int most_samples);

}  // namespace tactics
