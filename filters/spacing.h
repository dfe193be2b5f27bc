// SPDX-License-Identifier: Apache-2.0
// Lines kept so far apart that a finger tells them from each other.
#pragma once

#include "tactics/drawing.h"

namespace tactics {

/// What simplify may take from a gap after it was made: its tolerance on both sides.
inline constexpr double kMovedLater = 0.2;  // mm

/// Strokes in the order of their evidence; what of each runs within `gap` (between middle lines) of one before it, or of
/// an earlier part of itself, is cut away, and pieces shorter than `shortest` go. A line that ends on another keeps its
/// end if it comes to it steeply, and that end is led onto it; at a crossing the lesser line is broken. Two sides of a thin bar
/// become one line.
void keep_apart(Drawing& drawing, double gap, double shortest);

}  // namespace tactics
