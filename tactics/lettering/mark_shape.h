// SPDX-License-Identifier: Apache-2.0
// The shape of a piece of ink: whether it may be a letter, a mark of a plot or a dash.
#pragma once

#include <vector>

#include "tactics/drawing.h"
#include "tactics/lettering/read_line.h"

namespace tactics {

// Settings: pixels of the longer side; of the height of known print.
inline constexpr int kLeastMark = 9, kMostMark = 60;
inline constexpr double kLeastOfKnown = 0.7, kMostOfKnown = 1.4;

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

/// Neither read for sure nor told.
bool is_doubtful(const ReadLine& line);

/// Print that was read for sure or is told; if there is none, that which is likely.
using KnownPrint = std::vector<const LetteringLine*>;
KnownPrint known_print(const std::vector<ReadLine>& lines);
bool as_large_as_print(const MarkShape& shape, const KnownPrint& known);

Point middle_of(const PixelBox& box);
double gap_between(const PixelBox& a, const PixelBox& b);

}  // namespace tactics
