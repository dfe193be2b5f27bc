// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "filters/ticks.h"
#include "tactics/error.h"
#include "tactics/text/json.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr int kMostAxisTicks = 6;  // of an axis, as on paper
constexpr double kInset = 0.06;    // of the values' range, between points and the sides of the field
constexpr double kSteep = 0.4;     // of the field that a surface is high

struct Extent {
    double low = INFINITY, high = -INFINITY;
    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    void widen(double share, bool logarithmic) {
        const double by = share * (logarithmic ? std::log(high / low) : high - low);
        low = logarithmic ? low / std::exp(by) : low - by;
        high = logarithmic ? high * std::exp(by) : high + by;
    }
};

// `exact`: from the least value to the largest, and no round one beyond.
FeltAxis felt_axis(const Axis& axis, const Extent& extent, bool exact) {
    Ticks ticks = ticks_for(extent.low, extent.high, axis.logarithmic, kMostAxisTicks);
    if (exact && extent.high > extent.low) {
        ticks.low = extent.low;
        ticks.high = extent.high;
        std::erase_if(ticks.at, [&](double tick) { return tick < extent.low || tick > extent.high; });
    }
    return {ticks.low, ticks.high, axis.logarithmic, ticks.at};
}

}  // namespace

PlotFrame frame_of(const Plot& plot, const MountedField& field, double room) {
    Extent x, y, z;
    for (const PlotMark& mark : plot.marks) {
        x.take(mark.x);
        y.take(mark.y);
        if (plot.spatial) z.take(mark.z);
    }
    for (const PlotCurve& curve : plot.curves)
        for (const PlotPoint& point : curve.points) {
            x.take(point.x);
            y.take(point.y);
        }
    for (const PlotSurface& surface : plot.surfaces) {
        for (const double at : surface.x) x.take(at);
        for (const double at : surface.y) y.take(at);
        for (const double height : surface.z)
            if (std::isfinite(height)) z.take(height);
    }
    const bool solid = !plot.surfaces.empty();
    // A point on an axis would be behind its wall.
    if (!plot.marks.empty())
        for (auto [extent, axis] : {std::pair(&x, &plot.x), std::pair(&y, &plot.y)}) extent->widen(kInset, axis->logarithmic);
    PlotFrame frame;
    frame.x = felt_axis(plot.x, x, solid);
    frame.y = felt_axis(plot.y, y, solid);
    frame.width = field.width;
    frame.height = field.height;
    if (z.low <= z.high) {
        frame.z = felt_axis(plot.z, z, solid);
        frame.depth = std::min(kSteep * std::min(field.width, field.height), room);
    }
    return frame;
}

double room_over(const MountedField& field, const ArmSettings& arm) {
    const Mounting& mounting = field.mounting;
    const Point3 middle = mounting.to_device({field.width / 2, field.height / 2, 0});
    double room = INFINITY;
    const auto bound = [&](double at, double out, double half) {
        if (std::abs(out) > 1e-9) room = std::min(room, (half - std::copysign(1.0, out) * at) / std::abs(out));
    };
    bound(middle.x, mounting.out.x, arm.width / 2);
    bound(middle.y, mounting.out.y, arm.height / 2);
    bound(middle.z, mounting.out.z, arm.depth / 2);
    return std::max(0.0, room - kArmMargin);
}

Point most_of_plane(const ScenePlane& plane, const ArmSettings& arm) {
    constexpr double kSlim = 1e-3;  // a strip has all of the width
    const Workspace workspace{arm.width, arm.height, arm.depth};
    return {mount(plane, workspace, 1 / kSlim, kArmMargin).width, mount(plane, workspace, kSlim, kArmMargin).height};
}

void check_field(Point size) {
    if (!(size.x >= kLeastField && size.y >= kLeastField))
        throw Error(Fault::usage, "--plane",
                    phrase("the plane leaves a field of less than 30 mm in the workspace; take another"));
}

FittedBox fit_box(const ScenePlane& plane, const ArmSettings& arm, const Point3& size, double under) {
    const MountedField field = mount(plane, {arm.width, arm.height, arm.depth}, 1, kArmMargin);
    if (!(field.width > 0))
        throw Error(Fault::usage, "--plane", phrase("the plane passes beside the workspace, or at its side; take another"));
    FittedBox box{field.mounting, INFINITY};
    box.axes.origin = field.mounting.to_device({field.width / 2, field.height / 2, 0});
    // To either side of the place, how far the box reaches along each side of the workspace.
    const auto bound = [&](double at, double right, double down, double out, double whole) {
        const double beside = (std::abs(right) * size.x + std::abs(down) * size.y) / 2, half = whole / 2 - kArmMargin;
        const double above = out * (1 - under) * size.z, below = -out * under * size.z;
        const double forth = beside + std::max(above, below), back = beside - std::min(above, below);
        constexpr double kLeast = 1e-9;
        if (forth > kLeast) box.scale = std::min(box.scale, (half - at) / forth);
        if (back > kLeast) box.scale = std::min(box.scale, (half + at) / back);
    };
    const Mounting& m = box.axes;
    bound(m.origin.x, m.right.x, m.down.x, m.out.x, arm.width);
    bound(m.origin.y, m.right.y, m.down.y, m.out.y, arm.height);
    bound(m.origin.z, m.right.z, m.down.z, m.out.z, arm.depth);
    return box;
}

Mounting mounting_of(const FittedBox& box, const Point3& size, double under) {
    Mounting mounting = box.axes;
    mounting.origin = box.axes.to_device({-size.x / 2, -size.y / 2, -under * size.z});
    return mounting;
}

PlotFrame frame_of_box(const Point3& low, const Point3& high, double mm_each) {
    const auto axis = [](double from, double to) { return FeltAxis{from, to > from ? to : from + 1}; };
    const Point3 size = mm_each * (high - low);
    return {axis(low.x, high.x), axis(low.y, high.y), axis(low.z, high.z), size.x, size.y, size.z};
}

Phrase told_scale(const Point3& size, double scale) {
    const auto rounded = [](double value) {
        // Three digits.
        const double step = value > 0 ? std::pow(10, std::floor(std::log10(value)) - 2) : 1;
        return numeral(std::round(value / step) * step);
    };
    const auto words = [&](const Point3& box) {
        return phrase("{0} x {1} x {2} mm", rounded(box.x), rounded(box.y), rounded(box.z));
    };
    constexpr double kLeastTold = 1e-6;
    const Phrase larger = scale < kLeastTold ? phrase("far smaller") : phrase("{0} times as large", rounded(scale));
    return phrase("it is {0}, and is felt {1}: {2}", words(size), larger, words(scale * size));
}

namespace {

std::string json_of(const FeltAxis& axis, double length) {
    JsonObject json;
    json.add("low", axis.low);
    json.add("high", axis.high);
    json.add_raw("logarithmic", axis.logarithmic ? "true" : "false");
    json.add("mm", length);
    if (!axis.logarithmic && axis.high > axis.low) json.add("mm_each", length / (axis.high - axis.low));
    return json.text();
}

std::string json_of(const Point3& at) { return json_array({to_text(at.x), to_text(at.y), to_text(at.z)}); }

}  // namespace

std::string frame_json(const PlotFrame& frame, const Mounting& mounting) {
    JsonObject json;
    json.add_raw("x", json_of(frame.x, frame.width));
    json.add_raw("y", json_of(frame.y, frame.height));
    if (frame.depth > 0) json.add_raw("z", json_of(frame.z, frame.depth));
    json.add_raw("corner_mm", json_of(mounting.origin));
    json.add_raw("right", json_of(mounting.right));
    json.add_raw("down", json_of(mounting.down));
    json.add_raw("out", json_of(mounting.out));
    return "\"scene\":" + json.text();
}

}  // namespace tactics
