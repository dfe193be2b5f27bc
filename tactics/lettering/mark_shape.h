// SPDX-License-Identifier: Apache-2.0
// The shape of a piece of ink: whether it may be a letter, a mark of a plot or a dash.
#pragma once

#include "tactics/drawing.h"
#include "tactics/lettering/ink.h"

namespace tactics {

// Settings: pixels of the longer side.
inline constexpr int kLeastMark = 9, kMostMark = 60;

/// From the moments of its ink; lengths in pixels.
struct MarkShape {
    double side = 0, across = 0;  ///< of its box: the longer and the shorter
    double share = 0;             ///< of its box that is ink
    double band = 0;              ///< of a bar with these moments that is ink: bars and discs fill it
    double slant = 0;             ///< correlation of x and y, 0 to 1
    Point middle;                 ///< of its ink, in shares of its box
};
MarkShape mark_shape(const InkPiece& piece);

/// No bar and no disc, and neither too small nor too large.
bool is_letter_like(const MarkShape& shape);

/// Figures are as large as each other, too, but their ink lies otherwise.
bool same_mark(const MarkShape& a, const MarkShape& b);
bool same_size(const MarkShape& a, const MarkShape& b);

/// A dash of a curve where it bends, from end to end hardly longer than it is large. Letters turn more often, or branch.
bool is_bent_band(const InkPiece& piece);

Point middle_of(const PixelBox& box);
double gap_between(const PixelBox& a, const PixelBox& b);

}  // namespace tactics
