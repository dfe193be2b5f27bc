// SPDX-License-Identifier: Apache-2.0
// What lies around things: the one rectangle that geometry works with. A Rect (tactics/page.h) is a place that something is given
// on a page, told by its size; whole pixels have a PixelBox (tactics/image.h).
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "tactics/drawing.h"
#include "tactics/page.h"

namespace tactics {

/// An upright rectangle, told by its sides, mm.
struct Box {
    double left = 0, top = 0, right = 0, bottom = 0;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
    bool holds(Point p) const { return p.x >= left && p.x <= right && p.y >= top && p.y <= bottom; }  ///< its sides belong to it
    /// Grows until it holds the point, too.
    void take(Point p) {
        left = std::min(left, p.x);
        top = std::min(top, p.y);
        right = std::max(right, p.x);
        bottom = std::max(bottom, p.y);
    }
};

/// Around nothing: it meets no other, and holds what it takes.
inline constexpr double kNowhere = std::numeric_limits<double>::infinity();
inline constexpr Box kNothing{kNowhere, kNowhere, -kNowhere, -kNowhere};

/// With so much more on every side.
inline Box grown(const Box& box, double margin) {
    return {box.left - margin, box.top - margin, box.right + margin, box.bottom + margin};
}

/// They have a point in common, be it on their sides.
inline bool meet(const Box& a, const Box& b) {
    return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}

/// Around all of them; of no points: kNothing.
inline Box box_of(std::span<const Point> points) {
    Box box = kNothing;
    for (const Point& p : points) box.take(p);
    return box;
}

/// Of what is not drawn: kNothing.
inline Box box_of(const Region& region) {
    Box box = kNothing;
    for (const auto& ring : region.rings)
        for (const Point& p : ring) box.take(p);
    return box;
}

inline Box box_of(const Rect& rect) { return {rect.left, rect.top, rect.left + rect.width, rect.top + rect.height}; }
inline Rect rect_of(const Box& box) { return {box.left, box.top, box.width(), box.height()}; }

}  // namespace tactics
