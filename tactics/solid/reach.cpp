// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tactics/solid/space_grid.h"

namespace tactics {

namespace {

constexpr double kReachedShare = 0.5;  // of the places on a face that a hand comes to
constexpr double kSameWay = 0.99;      // cosine
constexpr double kBent = 1e-3;         // of the extent, by which the corners of a face may be off one plane, and more
constexpr double kBehind = 1.03e-3;    // share of the room for a hand: a thing no farther behind a place lies on it

// Possible obstacles for a hand: all patches of a model.
class Obstacles {
public:
    explicit Obstacles(const std::vector<ModelPart>& parts) : near_(boxes_of(parts)) {
        for (std::uint32_t part = 0; part < parts.size(); ++part) {
            extents_.push_back(space_of(parts[part]));
            extent_ = std::max(extent_, extent_of(parts[part]));
            for (const Patch& patch : parts[part].solid.patches) patches_.push_back({part, &patch});
        }
    }

    // Something is so near over that place that no hand comes there.
    bool cover(const Point3& at, const Point3& normal, std::uint32_t own, double hand) const {
        const Point3 tip = at + hand * normal;
        const SpaceBox ray{{std::min(at.x, tip.x), std::min(at.y, tip.y), std::min(at.z, tip.z)},
                           {std::max(at.x, tip.x), std::max(at.y, tip.y), std::max(at.z, tip.z)}};
        return near_.any_near(grown(ray, kBehind * hand), [&](std::uint32_t place) {
            const auto& [part, patch] = patches_[place];
            const double toward = dot(patch->normal, normal);
            if (std::abs(toward) < 1e-9 || apart(ray, extents_[part]) > 0) return false;
            const double along = dot(patch->normal, patch->rings.front().front() - at) / toward;
            if (part == own && toward > kSameWay && std::abs(along) < kBent * extent_) return false;  // it is the face itself
            return along > (part == own ? kBehind : -kBehind) * hand && along < (1 - kBehind) * hand &&
                   is_over(at + along * normal, patch->normal, patch->rings);
        });
    }

    double floor() const {
        double lowest = std::numeric_limits<double>::infinity();
        for (const SpaceBox& extent : extents_) lowest = std::min(lowest, extent.low.z);
        return lowest;
    }

private:
    static std::vector<SpaceBox> boxes_of(const std::vector<ModelPart>& parts) {
        std::vector<SpaceBox> boxes;
        for (const ModelPart& part : parts)
            for (const Patch& patch : part.solid.patches) boxes.push_back(space_of(patch));
        return boxes;
    }

    double extent_ = 0;                                            // mm, the longest of a part
    std::vector<SpaceBox> extents_;                                // of parts
    std::vector<std::pair<std::uint32_t, const Patch*>> patches_;  // and their parts
    SpaceGrid near_;
};

}  // namespace

void find_reached(Panels& made, const std::vector<ModelPart>& parts, const ReachWish& wish) {
    const Obstacles obstacles(parts);
    const double floor = obstacles.floor();
    for (Panel& panel : made.panels) {
        panel.reached = false;
        if (panel.rings.empty()) continue;
        // Shares that nobody builds by, so that no place lies just below the border of something else.
        const Point3 middle = middle_of(panel);
        std::vector<Point3> places = {middle + 0.0173 * (panel.rings.front().front() - middle)};
        for (const Point3& corner : panel.rings.front()) places.push_back(middle + 0.6127 * (corner - middle));
        std::erase_if(places, [&](const Point3& at) { return !is_over(at, panel.normal, panel.rings); });
        std::size_t free = 0;
        for (const Point3& at : places) {
            const bool grounded =
                wish.floor && panel.normal.z < -0.5 && at.z + wish.hand * panel.normal.z < floor - kBehind * wish.hand;
            free += !grounded && !obstacles.cover(at, panel.normal, panel.part, wish.hand);
        }
        panel.reached = places.empty() || static_cast<double>(free) >= kReachedShare * static_cast<double>(places.size());
    }
    // From within.
    for (Panel& panel : made.panels)
        if (panel.kind == PanelKind::bottom && !panel.rings.empty() && made.panels[panel.opening].reached) panel.reached = true;
}

}  // namespace tactics
