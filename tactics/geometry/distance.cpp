// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace tactics {

namespace {

double cross(Point o, Point a, Point b) { return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x); }

}  // namespace

Nearest nearest(const Segment& one, const Segment& other) {
    // They cross when each has its ends on both sides of the other. Where they only touch, an end is at distance 0.
    const double a = cross(other.a, other.b, one.a), b = cross(other.a, other.b, one.b);
    const double c = cross(one.a, one.b, other.a), d = cross(one.a, one.b, other.b);
    if (((a > 0 && b < 0) || (a < 0 && b > 0)) && ((c > 0 && d < 0) || (c < 0 && d > 0))) {
        const double t = a / (a - b);
        const Point p{one.a.x + t * (one.b.x - one.a.x), one.a.y + t * (one.b.y - one.a.y)};
        return {0, p, p};
    }
    // Compares squares, and all four before it chooses, because it is called for every two pieces that are near each other.
    const Point on_other_a = nearest_on(other, one.a), on_other_b = nearest_on(other, one.b);
    const Point on_one_a = nearest_on(one, other.a), on_one_b = nearest_on(one, other.b);
    const auto square = [](Point p, Point q) { return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y); };
    const double squares[] = {square(one.a, on_other_a), square(one.b, on_other_b), square(on_one_a, other.a),
                              square(on_one_b, other.b)};
    const int first = squares[1] < squares[0] ? 1 : 0, last = squares[3] < squares[2] ? 3 : 2;
    const int least = squares[last] < squares[first] ? last : first;
    if (!(squares[least] < std::numeric_limits<double>::infinity())) return {std::numeric_limits<double>::infinity(), {}, {}};
    switch (least) {
        case 0: return {std::sqrt(squares[0]), one.a, on_other_a};
        case 1: return {std::sqrt(squares[1]), one.b, on_other_b};
        case 2: return {std::sqrt(squares[2]), on_one_a, other.a};
        default: return {std::sqrt(squares[3]), on_one_b, other.b};
    }
}

Box box_of(const Segment& s, double margin) {
    return grown({std::min(s.a.x, s.b.x), std::min(s.a.y, s.b.y), std::max(s.a.x, s.b.x), std::max(s.a.y, s.b.y)}, margin);
}

double distance(const Box& a, const Box& b) {
    const double dx = std::max({0.0, a.left - b.right, b.left - a.right});
    const double dy = std::max({0.0, a.top - b.bottom, b.top - a.bottom});
    return std::sqrt(dx * dx + dy * dy);
}

Nearest nearest(const Segment& segment, const Box& box) {
    if (box.holds(segment.a)) return {0, segment.a, segment.a};
    const std::array<Point, 4> corners{
        {{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}}};
    Nearest best{std::numeric_limits<double>::infinity(), {}, {}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Nearest side = nearest(segment, Segment{corners[i], corners[(i + 1) % corners.size()]});
        if (side.distance < best.distance) best = side;
    }
    return best;
}

double greatest_extent(std::span<const Point> points) {
    constexpr int kDirections = 180;
    double extent = 0;
    for (int i = 0; i < kDirections && points.size() > 1; ++i) {
        const double angle = std::numbers::pi * i / kDirections, x = std::cos(angle), y = std::sin(angle);
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const Point& p : points) {
            const double along = p.x * x + p.y * y;
            least = std::min(least, along);
            most = std::max(most, along);
        }
        extent = std::max(extent, most - least);
    }
    return extent;
}

}  // namespace tactics
