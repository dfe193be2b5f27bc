// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/walk.h"

#include <algorithm>

namespace tactics {

Walk::Walk(std::span<const Point> points, bool closed)
    : points_(points), sides_(points.size() - (closed ? 0 : 1)), length_(distance(points[0], end_of_side())) {}

Point Walk::to(double along) {
    while (passed_ + length_ < along && side_ + 1 < sides_) {
        passed_ += length_;
        ++side_;
        length_ = distance(points_[side_], end_of_side());
    }
    const double t = length_ > 0 ? std::clamp((along - passed_) / length_, 0.0, 1.0) : 0;
    const Point a = points_[side_], b = end_of_side();
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

std::vector<Point> part_of(std::span<const Point> points, bool closed, double from, double to) {
    std::vector<Point> part;
    const std::size_t n = points.size(), sides = closed ? n : n - 1;
    double along = 0;
    for (std::size_t i = 0; along < to && i < 2 * sides; ++i) {
        const Point a = points[i % n], b = points[(i + 1) % n];
        const double side = distance(a, b);
        const auto at = [&](double place) {
            const double t = std::clamp((place - along) / side, 0.0, 1.0);
            return Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
        };
        if (side > 0 && along + side > from) {
            if (part.empty()) part.push_back(at(from));
            part.push_back(at(to));
        }
        along += side;
        if (!closed && i + 1 == sides) break;
    }
    return part;
}

}  // namespace tactics
