// SPDX-License-Identifier: Apache-2.0
// A line as a chain of dots.
#pragma once

#include <span>
#include <vector>

#include "print/dots.h"

namespace tactics {

struct GridDot {
    int column = 0;
    int row = 0;
};

/// The dots that make a polyline feel like an even, connected line: each dot is one of the eight neighbours of the one before, no
/// dot stands beside the line where the next one suffices, and sharp corners keep their dot.
///
/// Every dot is the nearest dot to some point of the line, within kWaver of a pitch. Dots may repeat; parts of the line outside
/// the grid give columns or rows of -1 or one past the last.
std::vector<GridDot> dot_chain(std::span<const Point> points, bool closed, const DotGrid& grid);

/// A line that crosses the middle between two dots by less than this share of their distance stays with the first; otherwise, at
/// half a pitch, a tremor of 0.1 mm would move dots from one row to the other. Our own choice: at the wide gap of 5 mm it is 0.75
/// mm, half a dot.
inline constexpr double kWaver = 0.15;

/// A point where the line turns by more than this (degrees) within the smallest pitch on either side keeps its own dot. Our own
/// choice: a right angle must be a corner, and a circle of two pitches (turns of 28 degrees at that reach) must have none.
inline constexpr double kSharpTurn = 60;

}  // namespace tactics
