// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/flat_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tactics/geometry/course.h"

namespace tactics {

namespace {

// From the line through a and b, to its left.
double off_line(Point a, Point b, Point at) {
    const double length = distance(a, b);
    return length > 0 ? ((b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x)) / length : 0;
}

template <typename Take>  // from, to; ends when it gives true
bool any_side(const FlatShape& shape, Take take) {
    for (const auto& ring : shape.rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            if (take(ring[i], ring[(i + 1) % ring.size()])) return true;
    return false;
}

// Places of a shape just within its border: from the middle of each side to the left and to the right, whichever is in it.
bool reaches_into(const FlatShape& one, const FlatShape& other, double touching) {
    return any_side(one, [&](Point a, Point b) {
        const double length = distance(a, b);
        if (!(length > 4 * touching)) return false;
        for (const double share : {0.5, 0.02, 0.98})
            for (const double side : {3.0, -3.0}) {
                const Point at{a.x + share * (b.x - a.x) - side * touching * (b.y - a.y) / length,
                               a.y + share * (b.y - a.y) + side * touching * (b.x - a.x) / length};
                if (holds(one, at) && holds(other, at) && distance_to_border(other, at) > touching) return true;
            }
        return false;
    });
}

}  // namespace

FlatShape flat_shape(std::vector<std::vector<Point>> rings) {
    FlatShape shape{std::move(rings)};
    for (const auto& ring : shape.rings)
        for (const Point& at : ring) shape.box.take(at);
    return shape;
}

bool cross(Point a, Point b, Point c, Point d, double touching) {
    const double one = off_line(a, b, c), two = off_line(a, b, d), three = off_line(c, d, a), four = off_line(c, d, b);
    const auto apart = [&](double s, double t) { return (s > touching && t < -touching) || (s < -touching && t > touching); };
    return apart(one, two) && apart(three, four);
}

ShapeMeeting meeting_of(const FlatShape& one, const FlatShape& other, double touching) {
    if (!boxes_meet(one, other, -touching)) return ShapeMeeting::apart;
    const bool crossing = any_side(
        one, [&](Point a, Point b) { return any_side(other, [&](Point c, Point d) { return cross(a, b, c, d, touching); }); });
    if (crossing) return ShapeMeeting::crossing;
    const bool in = reaches_into(one, other, touching), round = reaches_into(other, one, touching);
    if (in && round) {
        // The same shape twice, or the larger round the smaller with sides in common.
        const auto area = [](const Box& box) { return box.width() * box.height(); };
        const Box round_it = grown(other.box, touching);
        const bool within = round_it.holds({one.box.left, one.box.top}) && round_it.holds({one.box.right, one.box.bottom});
        return within && area(one.box) <= area(other.box) ? ShapeMeeting::inside : ShapeMeeting::crossing;
    }
    return in ? ShapeMeeting::inside : round ? ShapeMeeting::round : ShapeMeeting::apart;
}

ShapeMeeting meeting_of(Point from, Point to, const FlatShape& shape, double touching) {
    if (any_side(shape, [&](Point a, Point b) { return cross(from, to, a, b, touching); })) return ShapeMeeting::crossing;
    const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
    return holds(shape, middle) && distance_to_border(shape, middle) > touching ? ShapeMeeting::inside : ShapeMeeting::apart;
}

bool holds(const FlatShape& shape, Point at) {
    bool in = false;
    any_side(shape, [&](Point a, Point b) {
        if (ray_meets(at, a, b)) in = !in;
        return false;
    });
    return in;
}

double distance_to_border(const FlatShape& shape, Point at) {
    double least = std::numeric_limits<double>::infinity();
    any_side(shape, [&](Point a, Point b) {
        least = std::min(least, distance_to_segment(at, a, b));
        return false;
    });
    return least;
}

double distance(const FlatShape& one, const FlatShape& other) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& ring : one.rings)
        for (const Point& at : ring) least = std::min(least, distance_to_border(other, at));
    for (const auto& ring : other.rings)
        for (const Point& at : ring) least = std::min(least, distance_to_border(one, at));
    return least;
}

bool boxes_meet(const FlatShape& one, const FlatShape& other, double margin) { return meet(grown(one.box, margin), other.box); }

}  // namespace tactics
