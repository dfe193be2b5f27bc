// SPDX-License-Identifier: Apache-2.0
// A surface of a plot as heights for printing, milling or haptics.
#pragma once

#include "tactics/plot.h"
#include "tactics/relief/read_heights.h"

namespace tactics {

inline constexpr double kSurfaceWidth = 150;  ///< default, mm: about the width on which two hands rest

/// Seen from above, y upwards, its width and depth in proportion to the spans of x and y limited to a ratio of four, because x
/// and y may have different units. Heights between samples are bilinear in the four neighbours; the lowest is at `wish.low`
/// (default 0) and the highest at `wish.high` (default kPictureHeight). Unknown places are as low as the lowest, and the notes
/// say so. `wish.pitch` is 0.5 mm by default. Throws Error(usage), and Error(failed) for more samples than kMostHeights.
HeightFile surface_heights(const PlotSurface& surface, const HeightWish& wish);

}  // namespace tactics
