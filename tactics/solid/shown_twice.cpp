// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/shown_twice.h"

namespace tactics {

std::vector<std::uint32_t> shown_twice(const FlatLayout& layout, const Panels& panels, double touching) {
    std::vector<int> place(panels.panels.size(), -1);
    for (std::size_t i = 0; i < layout.panels.size(); ++i) place[layout.panels[i].panel] = static_cast<int>(i);
    std::vector<std::uint32_t> hinges;
    for (std::uint32_t i = 0; i < panels.hinges.size(); ++i) {
        const Hinge& hinge = panels.hinges[i];
        if (place[hinge.one] < 0 || place[hinge.other] < 0 || panels.panels[hinge.one].kind != PanelKind::side ||
            panels.panels[hinge.other].kind != PanelKind::side)
            continue;
        const Placement &one = layout.panels[static_cast<std::size_t>(place[hinge.one])].placement,
                        &other = layout.panels[static_cast<std::size_t>(place[hinge.other])].placement;
        if (distance(one.of(hinge.one_from), other.of(hinge.other_from)) > 20 * touching ||
            distance(one.of(hinge.one_to), other.of(hinge.other_to)) > 20 * touching)
            hinges.push_back(i);
    }
    return hinges;
}

}  // namespace tactics
