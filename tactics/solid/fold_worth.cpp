// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/fold_worth.h"

#include <algorithm>
#include <cmath>

#include "tactics/solid/largest_first.h"
#include "tactics/solid/layout.h"

namespace tactics {

FoldWorth::FoldWorth(const std::vector<ModelPart>& parts, const Panels& panels, const ViewPlane& view) : panels_(panels) {
    constexpr double kAlike = 1e-3;     // share up to which two are worth the same
    constexpr double kNearness = 1e-3;  // chance decides more than nearness, which comes first where nothing is left to chance
    const auto front = [&](const Panel& panel) { return 1 + 0.3 * dot(panel.normal, view.down); };
    const double touching = touching_in(parts);
    double extent = touching;
    for (const ModelPart& part : parts) extent = std::max(extent, extent_of(part));
    for (const Panel& panel : panels.panels) {
        size_.push_back(front(panel) * panel.area);
        const Point3 middle = panel.rings.empty() ? Point3{} : middle_of(panel);
        near_.push_back(1 + kNearness * (dot(middle, view.toward) + 2 * dot(middle, view.down)) / extent);
    }
    std::vector<double> sides;
    for (const Hinge& hinge : panels.hinges)
        for (const std::uint32_t child : {hinge.one, hinge.other}) {
            const Panel& panel = panels.panels[child];
            sides.push_back(front(panel) * length_of(hinge.one_to - hinge.one_from) /
                            std::sqrt(panel.area + touching * touching));
        }
    make_alike(size_, kAlike);
    make_alike(near_, kAlike * kNearness);
    make_alike(sides, kAlike);
    for (std::size_t i = 0; i < sides.size(); i += 2) sides_.push_back({sides[i], sides[i + 1]});
}

double FoldWorth::of(Strategy strategy, std::uint32_t hinge, std::uint32_t child, int folds) const {
    const double share = sides_[hinge][panels_.hinges[hinge].one == child ? 0 : 1];
    // By its own sides, if they have room.
    if (panels_.panels[child].kind == PanelKind::hanging) return 1e-9 * share;
    switch (strategy) {
        case Strategy::longest: return share;
        case Strategy::broadest: return 10.0 / (1 + folds) + share / (1 + share);
        case Strategy::largest: return size_[child];
        case Strategy::nearest: return near_[child];
        case Strategy::deepest: return folds + share / (1 + share);
    }
    return 0;
}

}  // namespace tactics
