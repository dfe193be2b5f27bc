// SPDX-License-Identifier: Apache-2.0
// Simplifies a line to fewer points.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

// Inline, because it is called very often.
inline Point nearest_on_segment(Point p, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    if (!(square > 0)) return a;
    const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
    return {a.x + t * dx, a.y + t * dy};
}
double distance_to_segment(Point p, Point a, Point b);  ///< mm
/// A ray from there to the right meets that side. If it meets an odd number of sides, the place is inside (even-odd rule).
inline bool ray_meets(Point p, Point a, Point b) {
    return (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
}

/// D. Douglas and T. Peucker, 1973: of the points between the kept ones `from` and `to` the farthest is kept too, until none is
/// farther than `tolerance` from the course of those that are kept. Without recursion; a few more points are kept where this
/// makes the time grow with the length instead of its square.
void keep_course(const std::vector<Point>& points, std::size_t from, std::size_t to, double tolerance, std::vector<bool>& keep);

/// The kept points of a whole line: its ends and those above; none for an empty line.
std::vector<Point> course_of(const std::vector<Point>& points, double tolerance);

}  // namespace tactics
