// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/space_grid.h"

#include <algorithm>
#include <array>
#include <limits>

namespace tactics {

namespace {

constexpr double kGridSize = 1000;  // of the longer side: a Grid has cells in mm of a page, models have any size
constexpr double kRounding = 1e-9 * kGridSize;

}  // namespace

SpaceGrid::SpaceGrid(std::vector<SpaceBox> boxes) : boxes_(std::move(boxes)) {
    if (boxes_.empty()) return;
    struct Axis {
        double Point3::*of;
        double low = std::numeric_limits<double>::infinity(), high = -low, lengths = 0;
        double length() const { return high - low; }
        double share() const { return length() > 0 ? lengths / length() : std::numeric_limits<double>::infinity(); }
    };
    std::array<Axis, 3> axes{{{&Point3::x}, {&Point3::y}, {&Point3::z}}};
    for (Axis& axis : axes)
        for (const SpaceBox& box : boxes_) {
            axis.low = std::min(axis.low, box.low.*axis.of);
            axis.high = std::max(axis.high, box.high.*axis.of);
            axis.lengths += box.high.*axis.of - box.low.*axis.of;
        }
    std::stable_sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.share() < b.share(); });
    across_ = axes[0].of;
    down_ = axes[1].of;
    left_ = axes[0].low;
    top_ = axes[1].low;
    const double longer = std::max(axes[0].length(), axes[1].length());
    scale_ = longer > 0 ? kGridSize / longer : 1;
    std::vector<Box> flat_boxes;
    flat_boxes.reserve(boxes_.size());
    for (const SpaceBox& box : boxes_) flat_boxes.push_back(flat(box));
    grid_ = Grid(std::move(flat_boxes), scale_ * axes[0].length(), scale_ * axes[1].length());
}

Box SpaceGrid::flat(const SpaceBox& box) const {
    return grown(Box{scale_ * (box.low.*across_ - left_), scale_ * (box.low.*down_ - top_), scale_ * (box.high.*across_ - left_),
                     scale_ * (box.high.*down_ - top_)},
                 kRounding);
}

std::vector<std::uint32_t> SpaceGrid::near(const SpaceBox& box) const {
    std::vector<std::uint32_t> found;
    any_near(box, [&](std::uint32_t place) {
        found.push_back(place);
        return false;
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace tactics
