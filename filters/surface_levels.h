// SPDX-License-Identifier: Apache-2.0
// A surface as lines of equal height.
#pragma once

#include <vector>

#include "tactics/plot.h"

namespace tactics {

/// The same axes with a curve for each of these heights that the surface has, named by it ("height = 20 m"); after each line of a
/// level the curve has a gap, and closed lines end where they began.
Plot levels_of(const Plot& plot, const PlotSurface& surface, const std::vector<double>& heights);

}  // namespace tactics
