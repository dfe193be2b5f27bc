// SPDX-License-Identifier: Apache-2.0
// Exact distances between the things that a page is made of.
#pragma once

#include <span>

#include "tactics/drawing.h"
#include "tactics/geometry/box.h"
#include "tactics/geometry/course.h"

namespace tactics {

struct Segment {
    Point a;
    Point b;
};

inline Point middle_of(const Segment& one) { return {(one.a.x + one.b.x) / 2, (one.a.y + one.b.y) / 2}; }

/// The nearest points of two things; one point, twice, where they meet.
struct Nearest {
    double distance = 0;
    Point one;
    Point other;
};

inline Point nearest_on(const Segment& segment, Point point) { return nearest_on_segment(point, segment.a, segment.b); }
Nearest nearest(const Segment& one, const Segment& other);

Box box_of(const Segment& segment, double margin);
double distance(const Box& a, const Box& b);              ///< 0 where they overlap
Nearest nearest(const Segment& segment, const Box& box);  ///< 0 where it enters

/// The greatest distance between two of the points, at most 0.004 % too small: the widest of 180 directions.
double greatest_extent(std::span<const Point> points);

}  // namespace tactics
