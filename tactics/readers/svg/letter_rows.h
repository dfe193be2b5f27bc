// SPDX-License-Identifier: Apache-2.0
// Shapes that stand in a row as the letters of a line do.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/geometry/box.h"

namespace tactics {

/// Of a figure 200 mm wide or high, letters are no larger, mm.
inline constexpr double kLargestLetter = 24;

/// A shape that may be a letter or a part of one.
struct Glyph {
    Box box;
    std::vector<std::size_t> rings;  ///< their numbers, whatever they count
    std::size_t corners = 0;         ///< of all of them
};
using Glyphs = std::vector<Glyph>;

/// Upwards is to the right then, and back.
inline Box turned(const Box& box) { return {-box.bottom, box.left, -box.top, box.right}; }
inline Box turned_back(const Box& box) { return {box.top, -box.right, box.bottom, -box.left}; }
inline Point turned(Point p) { return {-p.y, p.x}; }
inline Point turned_back(Point p) { return {p.y, -p.x}; }

/// From the left to the right.
struct LetterRow {
    Glyphs glyphs;
    bool upwards = false;  ///< their boxes are turned
    bool lone = false;     ///< one letter by itself, maybe with a sign, as high as letters of others
    bool alike = false;    ///< all are the same shape, as points of a row are, and the figures of "22"
    bool doubt = false;    ///< something else that may be of it is there: a raised figure, or the rest of a word on a slope
};

/// Of very many shapes not all are found.
std::vector<LetterRow> letter_rows(Glyphs glyphs);

Box box_of_row(const Glyphs& row);
/// Where the letters stand: most end there, the round ones of them a little below.
double base_of_row(const Glyphs& row);
/// An i and its dot are one letter.
Glyphs letters_of_row(const Glyphs& row);

}  // namespace tactics
