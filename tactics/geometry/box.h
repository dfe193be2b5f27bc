// SPDX-License-Identifier: Apache-2.0
// The bounding rectangle of all geometry. A Rect (tactics/page.h) is a place on a page, defined by its size; whole pixels have a
// PixelBox (tactics/image.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "tactics/drawing.h"
#include "tactics/page.h"

namespace tactics {

/// An upright rectangle, defined by its sides, mm.
struct Box {
    double left = 0, top = 0, right = 0, bottom = 0;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
    Point middle() const { return {(left + right) / 2, (top + bottom) / 2}; }
    bool holds(Point p) const { return p.x >= left && p.x <= right && p.y >= top && p.y <= bottom; }  ///< its sides belong to it
    /// Grows to include the point.
    void take(Point p) {
        left = std::min(left, p.x);
        top = std::min(top, p.y);
        right = std::max(right, p.x);
        bottom = std::max(bottom, p.y);
    }
};

/// The empty box: it meets no other, and grows to whatever it takes in.
inline constexpr double kNowhere = std::numeric_limits<double>::infinity();
inline constexpr Box kNothing{kNowhere, kNowhere, -kNowhere, -kNowhere};

/// Enlarged by that much on every side.
inline Box grown(const Box& box, double margin) {
    return {box.left - margin, box.top - margin, box.right + margin, box.bottom + margin};
}

/// Whether they share a point, including their sides.
inline bool meet(const Box& a, const Box& b) {
    return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}

/// Whether each side of one is less than that far from the other's.
inline bool same_box(const Box& a, const Box& b, double off) {
    return std::abs(a.left - b.left) < off && std::abs(a.right - b.right) < off && std::abs(a.top - b.top) < off &&
           std::abs(a.bottom - b.bottom) < off;
}

/// Around all of them; of no points: kNothing.
inline Box box_of(std::span<const Point> points) {
    Box box = kNothing;
    for (const Point& p : points) box.take(p);
    return box;
}

/// kNothing if it is not drawn.
inline Box box_of(const Region& region) {
    Box box = kNothing;
    for (const auto& ring : region.rings)
        for (const Point& p : ring) box.take(p);
    return box;
}

inline Box box_of(const Rect& rect) { return {rect.left, rect.top, rect.left + rect.width, rect.top + rect.height}; }
inline Rect rect_of(const Box& box) { return {box.left, box.top, box.width(), box.height()}; }

}  // namespace tactics
