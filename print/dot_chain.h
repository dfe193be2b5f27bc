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

/// The dots that make a polyline felt as an even, connected line: from its first dot to its last each next dot is one of
/// the eight neighbours, no dot stands beside the line where the next one would do, sharp corners keep their dot.
///
/// Every dot is a nearest dot to some point of the line, give or take kWaver of a pitch. Dots may repeat; a line or a
/// part of it that lies outside the grid gives columns or rows of -1 or one past the last.
std::vector<GridDot> dot_chain(std::span<const Point> points, bool closed, const DotGrid& grid);

/// A line that strays across the middle between two dots by less than this share of their distance stays with the
/// first: at half a pitch a shake of 0.1 mm would throw dots from one row to the other. Own choice: at the wide gap of
/// 5 mm it is 0.75 mm, half of a dot.
inline constexpr double kWaver = 0.15;

/// A place where the line turns by more than this (degrees) within the smallest pitch on either side keeps its own dot.
/// Own choice: a right angle must be a corner, a circle of two pitches (turns of 28 degrees at that reach) has none.
inline constexpr double kSharpTurn = 60;

}  // namespace tactics
