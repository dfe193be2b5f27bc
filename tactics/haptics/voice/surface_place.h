// SPDX-License-Identifier: Apache-2.0
// A surface of a plot at one place: how high it is, and how it slopes.
#pragma once

#include <limits>

#include "tactics/plot.h"

namespace tactics {

/// Bilinear between the four samples around.
struct SurfacePlace {
    double height = std::numeric_limits<double>::quiet_NaN();  ///< not a number: beside it, or one of the four is not known
    double along_x = 0, along_y = 0;                           ///< how the height grows with each
};

/// Allocates nothing.
SurfacePlace place_on(const PlotSurface& surface, double x, double y) noexcept;

}  // namespace tactics
