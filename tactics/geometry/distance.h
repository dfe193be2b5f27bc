// SPDX-License-Identifier: Apache-2.0
// Exact distances between the things that a page is made of.
#pragma once

#include <span>

#include "tactics/drawing.h"
#include "tactics/geometry/course.h"

namespace tactics {

struct Segment {
    Point a;
    Point b;
};

/// The nearest points of two things; one point, twice, where they meet.
struct Nearest {
    double distance = 0;
    Point one;
    Point other;
};

inline Point nearest_on(const Segment& segment, Point point) { return nearest_on_segment(point, segment.a, segment.b); }
Nearest nearest(const Segment& one, const Segment& other);

/// An upright rectangle. Unlike Rect it is told by its sides, which is what distances need.
struct Box {
    double left = 0, top = 0, right = 0, bottom = 0;
};
Box box_of(const Segment& segment, double margin);
inline bool meet(const Box& a, const Box& b) {
    return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}
double distance(const Box& a, const Box& b);              ///< 0 where they overlap
Nearest nearest(const Segment& segment, const Box& box);  ///< 0 where it enters

/// The greatest distance between two of the points, at most 0.004 % too small: the widest of 180 directions.
double greatest_extent(std::span<const Point> points);

}  // namespace tactics
