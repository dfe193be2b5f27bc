// SPDX-License-Identifier: Apache-2.0
// A surface of a plot at one place: its height and its slope.
#pragma once

#include <limits>

#include "tactics/plot.h"

namespace tactics {

/// Bilinear between the four surrounding samples.
struct SurfacePlace {
    double height = std::numeric_limits<double>::quiet_NaN();  ///< NaN: outside the surface, or one of the four is unknown
    double along_x = 0, along_y = 0;                           ///< partial derivatives of the height
};

/// Allocates nothing.
SurfacePlace place_on(const PlotSurface& surface, double x, double y) noexcept;

}  // namespace tactics
