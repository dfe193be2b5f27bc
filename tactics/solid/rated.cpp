// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/rated.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace tactics {

namespace {

constexpr double kWedgeShows = 1.0 / 3;
constexpr double kEdgeShows = 1.0 / 3;  // of a face, which is counted already

}  // namespace

Rating rating_of(const FlatLayout& layout, const std::vector<ModelPart>& parts, const Panels& panels, const ReaderWish& reader) {
    double all = 0, all_area = 0, shown = 0, shown_area = 0, asked = 0;
    std::vector<std::size_t> outlines(parts.size(), 0);
    // Hanging parts are shown by a single view; no more is required.
    std::vector<bool> hangs(parts.size(), false);
    for (const PlacedPanel& placed : layout.panels) {
        const Panel& panel = panels.panels[placed.panel];
        if (panel.kind != PanelKind::hanging) continue;
        hangs[panel.part] = true;
        ++all;
        all_area += panel.area;
    }
    for (const Panel& panel : panels.panels) {
        if (panel.kind == PanelKind::hanging || hangs[panel.part]) continue;
        if (is_view(panel.kind) && ++outlines[panel.part] > most_outlines(parts[panel.part].form)) continue;
        if (!panel.reached) continue;
        ++all;
        all_area += panel.area;
    }
    for (const PlacedPanel& placed : layout.panels) {
        const Panel& panel = panels.panels[placed.panel];
        ++shown;
        shown_area += panel.area;
        switch (placed.handling) {
            case Handling::folded: asked += reader.fold + (placed.folds - 1) * reader.fold_again; break;
            case Handling::lying: asked += reader.lay; break;
            case Handling::straightened: asked += reader.straighten; break;
            default: break;
        }
    }
    for (const PlacedBar& bar : layout.bars) {
        shown += panels.bars[bar.bar].is_edge ? kEdgeShows : bar.handling == Handling::wedge ? kWedgeShows : 1;
        asked += bar.handling == Handling::wedge ? reader.wedge : bar.handling == Handling::flattened ? reader.flatten : 0;
    }
    all +=
        static_cast<double>(std::count_if(panels.bars.begin(), panels.bars.end(), [](const Bar& bar) { return !bar.is_edge; }));
    std::array<bool, 6> kinds{};
    for (const PlacedPanel& placed : layout.panels) kinds[static_cast<std::size_t>(placed.handling)] = true;
    for (const PlacedBar& bar : layout.bars) kinds[static_cast<std::size_t>(bar.handling)] = true;
    Rating rating;
    const double by_number = all > 0 ? std::min(1.0, shown / all) : 1,
                 by_area = all_area > 0 ? std::min(1.0, shown_area / all_area) : by_number;
    std::vector<double> seen(parts.size(), 0);
    for (const PlacedPanel& placed : layout.panels) seen[panels.panels[placed.panel].part] = 1;
    for (const PlacedBar& bar : layout.bars) {
        double& one = seen[panels.bars[bar.bar].part];
        one = std::max(one, panels.bars[bar.bar].is_edge ? kEdgeShows : 1);
    }
    const double by_part = parts.empty() ? 1 : std::accumulate(seen.begin(), seen.end(), 0.0) / static_cast<double>(parts.size());
    rating.shown = (by_number + by_area + by_part) / 3;
    rating.asked =
        (all > 0 ? asked / all : 0) + reader.kind * static_cast<double>(std::count(kinds.begin() + 1, kinds.end(), true));
    return rating;
}

}  // namespace tactics
