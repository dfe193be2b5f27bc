// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/spread.h"

#include <algorithm>

#include "tactics/geometry/box.h"
#include "tactics/geometry/growing_grid.h"
#include "tactics/geometry/lots.h"
#include "tactics/solid/flat_shape.h"

namespace tactics {

namespace {

constexpr double kTouching = 0.01;  // of the smaller extent

bool touch(const Box& a, const Box& b) {
    const double least = std::min({a.width(), a.height(), b.width(), b.height()});
    return meet(grown(a, kTouching * least), b);
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
    // What came together may touch more, and is looked at again.
    Box around = kNothing;
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t i = 0; i < parts.size(); ++i)
        if (lots.find(i) == i) {
            waiting.push_back(i);
            take(around, foot[i]);
        }
    GrowingGrid near(around, waiting.size());
    std::vector<std::uint32_t> in_grid;
    while (!waiting.empty()) {
        const std::uint32_t one = waiting.back();
        waiting.pop_back();
        if (lots.find(one) != one) continue;
        const Box box = foot[one];
        bool joined = false;
        near.any_near(grown(box, kTouching * std::min(box.width(), box.height())), [&](std::size_t number) {
            const std::uint32_t other = lots.find(in_grid[number]);
            if (other == lots.find(one) || !touch(box, foot[other])) return false;
            const std::uint32_t first = std::min(other, lots.find(one));
            take(foot[first], foot[std::max(other, lots.find(one))]);
            lots.join(one, other);
            joined = true;
            return false;
        });
        if (joined) {
            waiting.push_back(lots.find(one));
        } else {
            in_grid.push_back(one);
            near.add(box);
        }
    }
    const auto is_first = [&](std::uint32_t i) { return lots.find(i) == i; };
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
