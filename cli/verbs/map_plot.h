// SPDX-License-Identifier: Apache-2.0
// Heights in mm as a plot: what words and charts tell of a relief or a model.
#pragma once

#include "tactics/plot.h"
#include "tactics/relief/heightmap.h"

namespace tactics {

/// Axes in mm, x to the right, y upwards and the height, and the surface of the map with so many samples along its longer side at
/// most; without one where the map has fewer than two rows or columns.
Plot plot_of_map(const HeightMap& map, int most_samples);

}  // namespace tactics
