// SPDX-License-Identifier: Apache-2.0
// Clips lines and rings to a rectangle.
#pragma once

#include <vector>

#include "tactics/drawing.h"
#include "tactics/page.h"

namespace tactics {

/// The parts of a line inside, in order, with unchanged points. A closed line that is cut gives open parts; the first and the
/// last meet at its beginning if that is inside.
std::vector<std::vector<Point>> clipped(const std::vector<Point>& points, bool closed, const Rect& rect);

/// The part of the ring's area inside, as one ring; fewer than three points: nothing. Several pieces stay joined by lines to and
/// fro along a side of the rectangle, which enclose nothing.
std::vector<Point> ring_within(std::vector<Point> ring, const Rect& rect);

}  // namespace tactics
