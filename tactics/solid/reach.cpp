// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tactics/solid/layout.h"
#include "tactics/solid/rings.h"
#include "tactics/solid/space_grid.h"

namespace tactics {

namespace {

constexpr double kReachedShare = 0.5;  // of the places on a face that a hand comes to
constexpr double kBehind = 1e-3;       // share of the room for a hand: a thing no farther behind a place lies on it
constexpr double kAlongHand = 1e-3;    // cosine up to which a patch is in the line of a hand, and no cover

// Possible obstacles for a hand: all patches of a model.
class Obstacles {
public:
    Obstacles(const std::vector<ModelPart>& parts, double hand)
        : hand_(hand), slack_(std::max(kBehind * hand, touching_in(parts))), near_(boxes_of(parts)) {
        for (std::uint32_t part = 0; part < parts.size(); ++part) {
            extents_.push_back(space_of(parts[part]));
            floor_ = std::min(floor_, extents_.back().low.z);
            for (const Patch& patch : parts[part].solid.patches) patches_.push_back({part, &patch});
        }
    }

    // Something is so near over that place that no hand comes there. What is over its border by the slack only covers it, and
    // what is just a hand away does not, so that the last digits of a file do not decide.
    bool cover(const Point3& at, const Point3& normal, std::uint32_t own) const {
        const Point3 tip = at + hand_ * normal;
        const SpaceBox ray{{std::min(at.x, tip.x), std::min(at.y, tip.y), std::min(at.z, tip.z)},
                           {std::max(at.x, tip.x), std::max(at.y, tip.y), std::max(at.z, tip.z)}};
        return near_.any_near(grown(ray, slack_), [&](std::uint32_t place) {
            const auto& [part, patch] = patches_[place];
            const double toward = dot(patch->normal, normal);
            if (std::abs(toward) < kAlongHand || apart(ray, extents_[part]) > slack_) return false;
            const double along = dot(patch->normal, patch->rings.front().front() - at) / toward;
            if (!(along > (part == own ? slack_ : -slack_) && along < hand_ - slack_)) return false;
            const Point3 there = at + along * normal;
            return is_over(there, patch->normal, patch->rings) || distance_to_rings(there, patch->rings) < slack_;
        });
    }

    bool is_on_floor(const Point3& at, const Point3& normal) const {
        return normal.z < -0.5 && at.z + hand_ * normal.z < floor_ - slack_;
    }
    double slack() const { return slack_; }

private:
    static std::vector<SpaceBox> boxes_of(const std::vector<ModelPart>& parts) {
        std::vector<SpaceBox> boxes;
        for (const ModelPart& part : parts)
            for (const Patch& patch : part.solid.patches) boxes.push_back(space_of(patch));
        return boxes;
    }

    double hand_, slack_, floor_ = std::numeric_limits<double>::infinity();
    std::vector<SpaceBox> extents_;                                // of parts
    std::vector<std::pair<std::uint32_t, const Patch*>> patches_;  // and their parts
    SpaceGrid near_;
};

}  // namespace

void find_reached(Panels& made, const std::vector<ModelPart>& parts, const ReachWish& wish) {
    const Obstacles obstacles(parts, wish.hand);
    for (Panel& panel : made.panels) {
        panel.reached = false;
        if (panel.rings.empty()) continue;
        std::vector<Point3> places = {middle_of(panel)};
        for (const Point3& corner : panel.rings.front()) places.push_back(places.front() + 0.6 * (corner - places.front()));
        std::erase_if(places, [&](const Point3& at) {
            return !is_over(at, panel.normal, panel.rings) || distance_to_rings(at, panel.rings) < obstacles.slack();
        });
        std::size_t free = 0;
        for (const Point3& at : places)
            free += !(wish.floor && obstacles.is_on_floor(at, panel.normal)) && !obstacles.cover(at, panel.normal, panel.part);
        panel.reached = places.empty() || static_cast<double>(free) >= kReachedShare * static_cast<double>(places.size());
    }
    // From within.
    for (Panel& panel : made.panels)
        if (panel.kind == PanelKind::bottom && !panel.rings.empty() && made.panels[panel.opening].reached) panel.reached = true;
}

}  // namespace tactics
