// SPDX-License-Identifier: Apache-2.0
// A surface of a plot as heights to be printed, milled or felt.
#pragma once

#include "tactics/plot.h"
#include "tactics/relief/read_heights.h"

namespace tactics {

inline constexpr double kSurfaceWidth = 150;  ///< mm, if nothing is said: about what two hands rest on

/// Seen from above, y upwards, its width and depth in proportion to the spans of x and y unless one is over four times the other,
/// which is then four times: x and y may be of other kinds. Heights between samples lie on the bilinear surface through the four
/// around; the lowest is at `wish.low` (0) and the highest at `wish.high` (kPictureHeight). Where nothing is known it is as low
/// as the lowest place, and the notes say so. `wish.pitch` is 0.5 mm if nothing is said. Throws Error(usage), and Error(failed)
/// for more samples than kMostHeights.
HeightFile surface_heights(const PlotSurface& surface, const HeightWish& wish);

}  // namespace tactics
