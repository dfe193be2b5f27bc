// The course of a line in fewer points.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

Point nearest_on_segment(Point p, Point a, Point b);
double distance_to_segment(Point p, Point a, Point b);  ///< mm

/// D. Douglas and T. Peucker, 1973: of the points between the kept ones `from` and `to` the farthest is kept too, until none is
/// farther than `tolerance` from the course of those that are kept. Without recursion.
void keep_course(const std::vector<Point>& points, std::size_t from, std::size_t to, double tolerance, std::vector<bool>& keep);

}  // namespace tactics
