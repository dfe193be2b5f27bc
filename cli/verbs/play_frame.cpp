// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "filters/ticks.h"

namespace tactics {

namespace {

constexpr int kMostTicks = 6;    // of an axis, as on paper
constexpr double kInset = 0.06;  // of the values' range, between points and the sides of the field
constexpr double kSteep = 0.4;   // of the field that a surface is high

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
    Ticks ticks = ticks_for(extent.low, extent.high, axis.logarithmic, kMostTicks);
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

double room_over(const MountedField& field, const ArmSettings& arm, double margin) {
    const Mounting& mounting = field.mounting;
    const Point3 middle = mounting.to_device({field.width / 2, field.height / 2, 0});
    double room = INFINITY;
    const auto bound = [&](double at, double out, double half) {
        if (std::abs(out) > 1e-9) room = std::min(room, (half - std::copysign(1.0, out) * at) / std::abs(out));
    };
    bound(middle.x, mounting.out.x, arm.width / 2);
    bound(middle.y, mounting.out.y, arm.height / 2);
    bound(middle.z, mounting.out.z, arm.depth / 2);
    return std::max(0.0, room - margin);
}

}  // namespace tactics
