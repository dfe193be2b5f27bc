// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/space_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tactics {

SpaceBox space_of(const ModelPart& part) {
    Point3 half;
    for (std::size_t i = 0; i < 3; ++i) {
        const Point3& axis = part.box.axis[i];
        half = half + part.box.half[i] * Point3{std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)};
    }
    return {part.box.middle - half, part.box.middle + half};
}

SpaceBox space_of(const Patch& patch) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    SpaceBox box{{kNone, kNone, kNone}, {-kNone, -kNone, -kNone}};
    for (const auto& ring : patch.rings)
        for (const Point3& at : ring) {
            box.low = {std::min(box.low.x, at.x), std::min(box.low.y, at.y), std::min(box.low.z, at.z)};
            box.high = {std::max(box.high.x, at.x), std::max(box.high.y, at.y), std::max(box.high.z, at.z)};
        }
    return box;
}

SpaceBox grown(const SpaceBox& box, double margin) {
    const Point3 more{margin, margin, margin};
    return {box.low - more, box.high + more};
}

double apart(const SpaceBox& a, const SpaceBox& b) {
    const auto gap = [](double low, double high, double other_low, double other_high) {
        return std::max({0.0, other_low - high, low - other_high});
    };
    return std::max({gap(a.low.x, a.high.x, b.low.x, b.high.x), gap(a.low.y, a.high.y, b.low.y, b.high.y),
                     gap(a.low.z, a.high.z, b.low.z, b.high.z)});
}

}  // namespace tactics
