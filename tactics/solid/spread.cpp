// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/spread.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "tactics/drawing.h"

namespace tactics {

namespace {

constexpr double kTouching = 0.01;  // of the smaller extent

struct Footprint {
    Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    void take(Point at) {
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    void take(const Footprint& other) {
        take(other.low);
        take(other.high);
    }
    double least() const { return std::min(high.x - low.x, high.y - low.y); }
};

bool touch(const Footprint& a, const Footprint& b) {
    const double slack = kTouching * std::min(a.least(), b.least());
    return a.low.x <= b.high.x + slack && b.low.x <= a.high.x + slack && a.low.y <= b.high.y + slack &&
           b.low.y <= a.high.y + slack;
}

void move(ModelPart& part, const Point3& by) {
    part.frame.middle = part.frame.middle + by;
    part.box.middle = part.box.middle + by;
    for (Patch& patch : part.solid.patches)
        for (auto& ring : patch.rings)
            for (Point3& at : ring) at = at + by;
    for (Seam& seam : part.solid.seams) {
        seam.from = seam.from + by;
        seam.to = seam.to + by;
    }
}

}  // namespace

std::vector<ModelPart> spread_out(const std::vector<ModelPart>& parts, const std::vector<std::uint32_t>& thing,
                                  const ViewPlane& view, double by) {
    // Of each thing first, by the number of its first part.
    std::vector<Footprint> foot(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (const Patch& patch : parts[i].solid.patches)
            for (const auto& ring : patch.rings)
                for (const Point3& at : ring) foot[thing[i]].take(Point{dot(at, view.right), dot(at, view.up)});
    std::vector<std::uint32_t> group(parts.size());
    std::iota(group.begin(), group.end(), 0u);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::uint32_t a = 0; a < parts.size(); ++a)
            for (std::uint32_t b = a + 1; b < parts.size(); ++b) {
                if (thing[a] != a || thing[b] != b || group[a] == group[b] || !touch(foot[group[a]], foot[group[b]])) continue;
                const std::uint32_t kept = std::min(group[a], group[b]), gone = std::max(group[a], group[b]);
                foot[kept].take(foot[gone]);
                for (std::uint32_t& one : group)
                    if (one == gone) one = kept;
                changed = true;
            }
    }
    Footprint all;
    std::size_t groups = 0;
    for (std::uint32_t i = 0; i < parts.size(); ++i)
        if (thing[i] == i && group[i] == i) {
            all.take(foot[i]);
            ++groups;
        }
    if (groups < 2) return {};
    const Point middle{(all.low.x + all.high.x) / 2, (all.low.y + all.high.y) / 2};
    std::vector<ModelPart> moved = parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Footprint& own = foot[group[thing[i]]];
        const Point off{(own.low.x + own.high.x) / 2 - middle.x, (own.low.y + own.high.y) / 2 - middle.y};
        move(moved[i], (by - 1) * (off.x * view.right + off.y * view.up));
    }
    return moved;
}

}  // namespace tactics
