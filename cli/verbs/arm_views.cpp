// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/arm_views.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "cli/choice_value.h"

namespace tactics {

namespace {

constexpr double kApart = 1;    // mm between places of the way that are drawn
constexpr double kBeside = 10;  // mm from what has no width or no depth: a finger on it is not in it

bool is_within(double at, double side) { return side > 0 ? at >= 0 && at <= side : std::abs(at) <= kBeside; }

// The places of the way in values; where it was beside the field there are none.
std::vector<Point3> values_of(const ArmScene& scene, const std::vector<TickRecord>& records) {
    const PlotFrame& frame = scene.frame;
    std::vector<Point3> way;
    Point3 last{-INFINITY, 0, 0};
    for (const TickRecord& one : records) {
        const Point3 at{one.at.x, one.at.y, one.finger};
        // Behind an axis there are no values, and on a logarithmic one none below its end.
        if (!(is_within(at.x, frame.width) && is_within(at.y, frame.height)) || length_of(at - last) < kApart) continue;
        last = at;
        Point3 values = frame.values(at);
        if (!(frame.width > 0)) values.x = frame.x.low;
        if (!(frame.height > 0)) values.y = frame.y.low;
        if (!(frame.depth > 0)) values.z = at.z;
        way.push_back(values);
    }
    return way;
}

PlotCurve curve_of(const std::vector<Point3>& way, bool onto) {
    PlotCurve curve{"way of the finger", {}};
    for (const Point3& at : way) curve.points.push_back({at.x, onto ? at.y : at.z});
    return curve;
}

// Along the plane that they lie in.
std::vector<PlotCurve> edge_on(const std::vector<PlotCurve>& curves) {
    std::vector<PlotCurve> seen;
    for (const PlotCurve& curve : curves) {
        seen.push_back({curve.name, {}});
        const auto [least, most] =
            std::minmax_element(curve.points.begin(), curve.points.end(), [](PlotPoint a, PlotPoint b) { return a.x < b.x; });
        if (least != curve.points.end()) seen.back().points = {{least->x, 0}, {most->x, 0}};
    }
    return seen;
}

std::string titled(const std::string& title, const char* from) {
    return title.empty() ? std::string("Seen ") + from : title + ", " + from;
}

// The highest of a surface at each x.
PlotCurve outline_of(const PlotSurface& surface, const std::string& name) {
    PlotCurve outline{name, {}};
    for (std::size_t i = 0; i < surface.x.size(); ++i) {
        double highest = -INFINITY;
        for (std::size_t k = 0; k < surface.y.size(); ++k)
            if (std::isfinite(surface.at(i, k))) highest = std::max(highest, surface.at(i, k));
        if (std::isfinite(highest)) outline.points.push_back({surface.x[i], highest});
    }
    return outline;
}

}  // namespace

ArmView view_of(const Given& given) {
    constexpr ArmView kAll[] = {ArmView::both, ArmView::front, ArmView::above};
    return kAll[choice_value(given, "--view", {"both", "front", "above"}).value_or(0)];
}

std::size_t pages_of(ArmView view) { return view == ArmView::both ? 2 : 1; }

std::vector<Plot> arm_views(const ArmScene& scene, const std::vector<TickRecord>& records, ArmView view) {
    const std::vector<Point3> way = values_of(scene, records);
    Plot onto = scene.plot, along;
    onto.spatial = false;
    for (std::size_t i = 0; i < onto.curves.size(); ++i)
        if (onto.curves[i].name.empty()) onto.curves[i].name = "curve " + std::to_string(i + 1);
    along.x = onto.x;
    along.y = scene.frame.depth > 0 ? scene.plot.z : Axis{"from the plot, mm"};
    if (scene.contoured) {
        onto.curves = {{"contours", {}}};
        onto.surfaces = {*scene.contoured};
        along.curves = {{"contours", {{scene.contoured->x.front(), 0}, {scene.contoured->x.back(), 0}}}};
    } else {
        along.curves = edge_on(onto.curves);
    }
    if (!scene.plot.surfaces.empty()) {
        const std::string name = "outline and contours";
        onto.curves.push_back({name, {}});
        along.curves.push_back(outline_of(onto.surfaces.front(), name));
    }
    if (scene.sheet) {
        onto.curves.push_back(scene.sheet->onto);
        along.curves.push_back(scene.sheet->along);
    }
    if (scene.plot.spatial)
        for (PlotMark mark : scene.plot.marks) {
            mark.y = mark.z;
            along.marks.push_back(std::move(mark));
        }
    if (way.size() > 1) {
        onto.curves.push_back(curve_of(way, true));
        along.curves.push_back(curve_of(way, false));
    }
    // A flat thing is seen along its plane from the front; one in front of the person, from above.
    const bool flat = std::abs(scene.mounting.out.y) > std::abs(scene.mounting.out.z);
    along.y.downwards = !flat;
    Plot front = flat ? along : onto, above = flat ? std::move(onto) : std::move(along);
    front.title = titled(scene.plot.title, "from the front");
    above.title = titled(scene.plot.title, "from above");
    std::vector<Plot> views;
    if (view != ArmView::above) views.push_back(std::move(front));
    if (view != ArmView::front) views.push_back(std::move(above));
    return views;
}

}  // namespace tactics
