// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/panel.h"

#include <cmath>
#include <utility>

#include "tactics/geometry/box.h"
#include "tactics/geometry/convex.h"

namespace tactics {

Point3 middle_of(const Panel& panel) {
    Point3 sum;
    for (const Point3& point : panel.rings.front()) sum = sum + point;
    return (1.0 / static_cast<double>(panel.rings.front().size())) * sum;
}

bool is_narrow(const Panel& panel, double apart) {
    if (panel.kind != PanelKind::side || panel.rings.empty()) return false;
    const Point3 u = unit(panel.rings.front()[1] - panel.rings.front()[0]), v = cross(panel.normal, u);
    std::vector<Point> corners;
    for (const Point3& at : panel.rings.front()) corners.push_back({dot(at, u), dot(at, v)});
    const Box box = box_of(corners);
    if (panel.area >= apart * std::hypot(box.width(), box.height())) return false;
    // What is convex is least wide across one of its sides.
    const Convex hull = hull_of(std::move(corners));
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point &from = hull[i], &to = hull[(i + 1) % hull.size()];
        const double length = distance(from, to);
        if (!(length > 0)) continue;
        const Point across{(from.y - to.y) / length, (to.x - from.x) / length}, back{-across.x, -across.y};
        if (reach_of(hull, across) + reach_of(hull, back) < apart) return true;
    }
    return false;
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
