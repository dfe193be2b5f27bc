// SPDX-License-Identifier: Apache-2.0
// Convex polygons by their corners, with the inside on the left of each side as x and y would have it in mathematics.
#pragma once

#include <span>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

using Convex = std::vector<Point>;

/// Round all of these (A. M. Andrew, 1979); a line or a point of fewer than three corners if they lie on one.
Convex hull_of(std::vector<Point> points);
double area_of(const Convex& one);
/// What both cover (I. E. Sutherland, G. W. Hodgman, 1974).
Convex common_part(const Convex& one, const Convex& other);
/// How far one reaches in a direction.
double reach_of(const Convex& one, Point direction);

/// Of the lines that may lie between two: the one with the most room between them, or where they overlap the least overlap.
struct Parting {
    double room = 0;  ///< < 0: they overlap by as much
    Point way;        ///< of length 1, from the one to the other
};
/// `along`: only that direction, if it is not zero.
Parting parting_of(const Convex& one, const Convex& other, Point along = {});

}  // namespace tactics
