// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/panel.h"

namespace tactics {

Point3 middle_of(const Panel& panel) {
    Point3 sum;
    for (const Point3& point : panel.rings.front()) sum = sum + point;
    return (1.0 / static_cast<double>(panel.rings.front().size())) * sum;
}

Panels moved(Panels panels, const std::vector<Point3>& by) {
    const auto move = [](Point3& at, const Point3& way) { at = at + way; };
    for (Panel& panel : panels.panels) {
        for (auto& ring : panel.rings)
            for (Point3& at : ring) move(at, by[panel.part]);
        for (PanelLine& line : panel.lines)
            for (Point3& at : line.points) move(at, by[panel.part]);
    }
    for (Hinge& hinge : panels.hinges) {
        for (Point3* at : {&hinge.one_from, &hinge.one_to}) move(*at, by[panels.panels[hinge.one].part]);
        for (Point3* at : {&hinge.other_from, &hinge.other_to}) move(*at, by[panels.panels[hinge.other].part]);
    }
    for (Bar& bar : panels.bars) {
        move(bar.held, by[bar.part]);
        move(bar.loose, by[bar.part]);
    }
    return panels;
}

}  // namespace tactics
