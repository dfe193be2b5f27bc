// SPDX-License-Identifier: Apache-2.0
// What of lines and rings lies within a rectangle.
#pragma once

#include <vector>

#include "tactics/drawing.h"
#include "tactics/page.h"

namespace tactics {

/// The parts of a line within, in their order; points of the line are in them as they are. A closed one that is cut comes in
/// parts that are not, the first and the last of them meeting where it began if that is within.
std::vector<std::vector<Point>> clipped(const std::vector<Point>& points, bool closed, const Rect& rect);

/// What of the ring's inside is within, as one ring; fewer than three points: nothing. Where it falls into several pieces they
/// stay joined along a side of the rectangle, to and fro, which encloses nothing.
std::vector<Point> ring_within(std::vector<Point> ring, const Rect& rect);

}  // namespace tactics
