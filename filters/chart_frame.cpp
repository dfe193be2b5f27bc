// SPDX-License-Identifier: Apache-2.0
#include "filters/chart_frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "filters/axis_room.h"
#include "filters/chart_key.h"
#include "filters/plot_symbols.h"
#include "tactics/error.h"

namespace tactics {

namespace {

constexpr double kLeastSide = 50;  // mm; a smaller field of data cannot be read by touch

void check(const AxisExtent& extent) {
    if (!extent.holds_any()) throw Error(Fault::usage, "", phrase("there is nothing to plot"));
}

AxisExtent extent_across(const Plot& plot) {
    AxisExtent extent;
    for (const PlotMark& mark : plot.marks) extent.take(mark.x);
    for (const PlotCurve& curve : plot.curves)
        for (const PlotPoint& point : curve.points) extent.take(point.x);
    for (const PlotSurface& surface : plot.surfaces)
        for (const double x : surface.x) extent.take(x);
    check(extent);
    return extent;
}

// Bars stand on 0, and their last point says nothing of a height.
AxisExtent extent_up(const Plot& plot) {
    AxisExtent extent;
    for (const PlotMark& mark : plot.marks) extent.take(mark.y);
    for (const PlotCurve& curve : plot.curves) {
        const bool bars = curve.joined == Joining::bars && curve.points.size() > 1;
        for (std::size_t i = 0; i + (bars ? 1 : 0) < curve.points.size(); ++i) extent.take(curve.points[i].y);
        if (bars && !plot.y.logarithmic) extent.take(0);
    }
    for (const PlotSurface& surface : plot.surfaces)
        for (const double y : surface.y) extent.take(y);
    check(extent);
    return extent;
}

// Times of day belong to a day.
std::string name_of(const Axis& axis, const AxisExtent& extent) {
    const std::string since = axis_ticks(axis, extent, kMostAxisTicks).since;
    return since.empty() ? axis.name : axis.name + (axis.name.empty() ? "" : ", ") + since;
}

}  // namespace

ChartFrame frame_for(const Plot& plot, const Sheet& sheet, const Clearance& clear, double width, double bottom) {
    const AxisExtent x = extent_across(plot), y = extent_up(plot);
    const std::vector<std::string> name_x = lines_within(name_of(plot.x, x), width, sheet),
                                   name_y = lines_within(name_of(plot.y, y), width, sheet);
    // The ticks' words decide how much room is left; an upright block of words is about as high as 12 mm.
    const LabelBlock words_x = widest_words(plot.x, x, sheet), words_y = widest_words(plot.y, y, sheet);
    // Half of the lowest tick's words hang below the axis.
    const double below = std::max(kChartTick + clear.down, words_y.height / 2 + kChartLines);
    const double top = height_of(name_y, sheet);
    Rect field;
    field.left = words_y.width + clear.across + kChartTick;
    field.top = top + words_y.height / 2 + kChartLines;
    field.width = width - words_x.width / 2 - field.left;
    field.height = bottom - height_of(name_x, sheet) - words_x.height - 2 * kChartLines - below - field.top;
    // A letter has room over the highest mark.
    const double over = set_label("m", sheet).height + clear.mark + clear.down + kChartLines - (field.top - top);
    if (field.width < kLeastSide || field.height < kLeastSide + over)
        throw Error(Fault::usage, "",
                    phrase("the chart does not fit on this paper; take larger paper, or fewer things to compare"));
    // No mark touches an axis or its ticks, or leaves the drawing.
    double reach = clear.mark;
    for (const PlotMark& mark : plot.marks) reach = std::max(reach, reach_of(mark.symbol, clear.mark));
    const double inset = kChartTick + reach + kChartClear + sheet.medium->thin_line, edge = reach + sheet.medium->thick_line;
    const AxisRoom across{field.left + inset, field.left + field.width - edge, false, clear.words, width};
    AxisRoom up{field.top + field.height - inset, field.top + std::max(edge, over), true, 0, width};
    if (plot.y.downwards) std::swap(up.from, up.to);
    return {field, top,           scale_for(plot.x, x, across, sheet), scale_for(plot.y, y, up, sheet), name_x, name_y,
            below, words_x.height};
}

std::vector<std::pair<Point, Point>> grid_lines(const ChartFrame& frame) {
    const Rect& field = frame.field;
    std::vector<std::pair<Point, Point>> lines;
    for (const double tick : frame.up.ticks())
        lines.push_back({{field.left, frame.up.at(tick)}, {field.left + field.width, frame.up.at(tick)}});
    for (const double tick : frame.across.ticks())
        lines.push_back({{frame.across.at(tick), field.top + field.height}, {frame.across.at(tick), field.top}});
    return lines;
}

void draw_axes(const ChartFrame& frame, const Clearance& clear, Drawing& drawing) {
    const Rect& field = frame.field;
    const double bottom = field.top + field.height;
    const auto line = [&](std::vector<Point> points, Role role) {
        drawing.strokes.push_back({std::move(points), false, LineClass::thin, 0, role});
    };
    line({{field.left, field.top}, {field.left, bottom}, {field.left + field.width, bottom}}, Role::axis);
    for (std::size_t i = 0; i < frame.across.ticks().size(); ++i) {
        const double at = frame.across.at(frame.across.ticks()[i]);
        line({{at, bottom - kChartTick}, {at, bottom + kChartTick}}, Role::tick);
        drawing.labels.push_back({{at, bottom + frame.below}, frame.across.before()[i], 0, frame.across.words()[i]});
    }
    for (std::size_t i = 0; i < frame.up.ticks().size(); ++i) {
        const double at = frame.up.at(frame.up.ticks()[i]);
        line({{field.left - kChartTick, at}, {field.left + kChartTick, at}}, Role::tick);
        drawing.labels.push_back({{field.left - kChartTick - clear.across, at}, 1, 0.5, frame.up.words()[i]});
    }
}

void draw_names(const ChartFrame& frame, const Sheet& sheet, Drawing& drawing) {
    const auto write = [&](Point at, double across, const std::vector<std::string>& lines) {
        for (const std::string& text : lines) {
            if (text.empty()) continue;
            drawing.labels.push_back({at, across, 0, text});
            at.y += set_label(text, sheet).height + kChartLines;
        }
    };
    const Rect& field = frame.field;
    write({0, 0}, 0, frame.name_y);
    write({field.left + field.width, field.top + field.height + frame.below + frame.ticks_x + kChartLines}, 1, frame.name_x);
}

}  // namespace tactics
