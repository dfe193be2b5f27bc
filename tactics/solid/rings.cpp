// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/rings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tactics/geometry/course.h"

namespace tactics {

namespace {

double distance_to_side(const Point3& at, const Point3& from, const Point3& to) {
    const Point3 along = to - from;
    const double length = dot(along, along);
    const double share = length > 0 ? std::clamp(dot(at - from, along) / length, 0.0, 1.0) : 0;
    return length_of(at - from - share * along);
}

}  // namespace

bool is_over(const Point3& at, const Point3& normal, const std::vector<std::vector<Point3>>& rings) {
    // Seen along the axis that it faces most.
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    const auto flat = [&](const Point3& p) {
        return z >= x && z >= y ? Point{p.x, p.y} : y >= x ? Point{p.x, p.z} : Point{p.y, p.z};
    };
    const Point place = flat(at);
    bool over = false;
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            if (ray_meets(place, flat(ring[i]), flat(ring[(i + 1) % ring.size()]))) over = !over;
    return over;
}

double distance_to_rings(const Point3& at, const std::vector<std::vector<Point3>>& rings) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            least = std::min(least, distance_to_side(at, ring[i], ring[(i + 1) % ring.size()]));
    return least;
}

}  // namespace tactics
