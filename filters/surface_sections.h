// SPDX-License-Identifier: Apache-2.0
// Sections of a surface: curves of its height along lines across it.
#pragma once

#include <string>
#include <vector>

#include "tactics/plot.h"

namespace tactics {

/// Where a surface is cut.
struct SectionWish {
    bool at_x = false;            ///< along y, at these x; else along x, at these y
    std::vector<double> at = {};  ///< empty: at up to five round values
};

/// A curve for each place, up to five, named by it ("north = 2 km"); heights between two samples lie on the straight line between
/// them, and where one is unknown the curve has a gap. Throws Error(usage) for a place beside the surface and for more than five.
Plot sections_of(const Plot& plot, const PlotSurface& surface, const SectionWish& wish);

}  // namespace tactics
