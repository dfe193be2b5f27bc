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

}  // namespace tactics
