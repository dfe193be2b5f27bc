// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/spread.h"

#include <algorithm>

#include "tactics/geometry/box.h"
#include "tactics/geometry/lots.h"

namespace tactics {

namespace {

constexpr double kTouching = 0.01;  // of the smaller extent

bool touch(const Box& a, const Box& b) {
    const double least = std::min({a.width(), a.height(), b.width(), b.height()});
    return meet(grown(a, kTouching * least), b);
}

void take(Box& box, const Box& other) {
    box.take({other.left, other.top});
    box.take({other.right, other.bottom});
}

Point middle_of(const Box& box) { return {(box.left + box.right) / 2, (box.top + box.bottom) / 2}; }

}  // namespace

std::vector<Point3> spread_by(const std::vector<ModelPart>& parts, const std::vector<std::uint32_t>& thing, const ViewPlane& view,
                              double times) {
    // Of what stays together, by the number of its first part.
    std::vector<Box> foot(parts.size(), kNothing);
    Lots lots(parts.size());
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        lots.join(thing[i], i);
        for (const Patch& patch : parts[i].solid.patches)
            for (const auto& ring : patch.rings)
                for (const Point3& at : ring) foot[thing[i]].take({dot(at, view.right), dot(at, view.down)});
    }
    const auto is_first = [&](std::uint32_t i) { return lots.find(i) == i; };
    for (bool changed = true; changed;) {
        changed = false;
        for (std::uint32_t a = 0; a < parts.size(); ++a)
            for (std::uint32_t b = a + 1; b < parts.size() && is_first(a); ++b) {
                if (!is_first(b) || !touch(foot[a], foot[b])) continue;
                take(foot[a], foot[b]);
                lots.join(a, b);
                changed = true;
            }
    }
    Box all = kNothing;
    std::size_t groups = 0;
    for (std::uint32_t i = 0; i < parts.size(); ++i)
        if (is_first(i)) {
            take(all, foot[i]);
            ++groups;
        }
    if (groups < 2) return {};
    const Point middle = middle_of(all);
    std::vector<Point3> by;
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        const Point own = middle_of(foot[lots.find(i)]);
        by.push_back((times - 1) * ((own.x - middle.x) * view.right + (own.y - middle.y) * view.down));
    }
    return by;
}

}  // namespace tactics
