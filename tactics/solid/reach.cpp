// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tactics/solid/space_box.h"

namespace tactics {

namespace {

constexpr double kReachedShare = 0.5;  // of the places on a face that a hand comes to

// Something is so near over that place that no hand comes there.
bool is_covered(const Point3& at, const Point3& normal, std::uint32_t own, const std::vector<ModelPart>& parts,
                const std::vector<SpaceBox>& extents, double hand) {
    const Point3 tip = at + hand * normal;
    const SpaceBox ray{{std::min(at.x, tip.x), std::min(at.y, tip.y), std::min(at.z, tip.z)},
                       {std::max(at.x, tip.x), std::max(at.y, tip.y), std::max(at.z, tip.z)}};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (apart(ray, extents[i]) > 0) continue;
        for (const Patch& patch : parts[i].solid.patches) {
            const double toward = dot(patch.normal, normal);
            if (std::abs(toward) < 1e-9) continue;
            const double along = dot(patch.normal, patch.rings.front().front() - at) / toward;
            if (along > (i == own ? 1e-3 : -1e-3) * hand && along < hand &&
                is_over(at + along * normal, patch.normal, patch.rings))
                return true;
        }
    }
    return false;
}

}  // namespace

void find_reached(Panels& made, const std::vector<ModelPart>& parts, const ReachWish& wish) {
    std::vector<SpaceBox> extents;
    double floor = std::numeric_limits<double>::infinity();
    for (const ModelPart& part : parts) {
        extents.push_back(space_of(part));
        floor = std::min(floor, extents.back().low.z);
    }
    for (Panel& panel : made.panels) {
        panel.reached = false;
        if (panel.rings.empty()) continue;
        std::vector<Point3> places = {middle_of(panel)};
        for (const Point3& corner : panel.rings.front()) places.push_back(places.front() + 0.6 * (corner - places.front()));
        std::erase_if(places, [&](const Point3& at) { return !is_over(at, panel.normal, panel.rings); });
        std::size_t free = 0;
        for (const Point3& at : places) {
            const bool grounded = wish.floor && panel.normal.z < -0.5 && at.z + wish.hand * panel.normal.z < floor;
            free += !grounded && !is_covered(at, panel.normal, panel.part, parts, extents, wish.hand);
        }
        panel.reached = places.empty() || static_cast<double>(free) >= kReachedShare * static_cast<double>(places.size());
    }
}

}  // namespace tactics
