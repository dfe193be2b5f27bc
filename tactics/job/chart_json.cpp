// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/chart_json.h"

#include <cmath>
#include <string_view>
#include <vector>

#include "tactics/error.h"
#include "tactics/layout/place.h"
#include "tactics/text/json.h"
#include "tactics/text/number.h"

namespace tactics {

namespace {

std::string value_json(double value) { return std::isnan(value) ? "null" : to_text(value); }
std::string_view truth(bool value) { return value ? "true" : "false"; }

std::string values_json(const std::vector<double>& values) {
    std::string json;
    for (const double value : values) json += (json.empty() ? "" : ",") + value_json(value);
    return "[" + json + "]";
}

std::string axis_json(const Axis& axis, const std::optional<AxisPlace>& place, double origin) {
    JsonObject json;
    json.add("name", axis.name);
    if (!place) return json.text();
    if (axis.logarithmic) json.add_raw("logarithmic", "true");
    if (axis.dates) json.add_raw("dates", "true");  // seconds since 1970
    json.add("low", place->low);
    json.add("high", place->high);
    json.add("from", origin + place->from);
    json.add("to", origin + place->to);
    return json.text();
}

std::string errors_json(const std::vector<PlotRange>& errors) {
    std::vector<std::string> all;
    for (const PlotRange& error : errors) all.push_back(std::isnan(error.low) ? "null" : values_json({error.low, error.high}));
    return json_array(all);
}

std::string bars_json(const PlotBars& bars, const ChartTold& told) {
    JsonObject json;
    json.add("direction", told.level ? "level" : "upright");
    json.add_raw("stacked", truth(bars.stacked));
    json.add_raw("categories", json_text_array(bars.categories));
    if (!told.letters.empty()) json.add_raw("letters", json_text_array(told.letters));
    std::vector<std::string> all;
    for (const PlotSeries& series : bars.series) {
        JsonObject one;
        one.add("name", series.name);
        one.add_raw("values", values_json(series.values));
        if (!series.errors.empty()) one.add_raw("errors", errors_json(series.errors));
        all.push_back(one.text());
    }
    json.add_raw("series", json_array(all));
    return json.text();
}

std::string curve_json(const PlotCurve& curve) {
    JsonObject json;
    json.add("name", curve.name);
    constexpr std::string_view kJoined[] = {"straight", "steps", "bars"};
    json.add("joined", kJoined[static_cast<std::size_t>(curve.joined)]);
    std::vector<std::string> points;
    for (const PlotPoint& point : curve.points) points.push_back(values_json({point.x, point.y}));
    json.add_raw("points", json_array(points));
    if (!curve.gaps.empty()) {  // no line leads to the points of these numbers, from 0
        std::vector<std::string> gaps;
        for (const std::size_t gap : curve.gaps) gaps.push_back(std::to_string(gap));
        json.add_raw("gaps", json_array(gaps));
    }
    return json.text();
}

std::string mark_json(const PlotMark& mark, bool spatial) {
    JsonObject json;
    if (!mark.name.empty()) json.add("name", mark.name);
    constexpr std::string_view kSymbol[kSymbols] = {"disc", "ring", "square", "triangle", "cross"};
    json.add("symbol", kSymbol[static_cast<std::size_t>(mark.symbol)]);
    json.add("x", mark.x);
    json.add("y", mark.y);
    if (spatial) json.add("z", mark.z);
    return json.text();
}

std::string surface_json(const PlotSurface& surface) {
    JsonObject json;
    json.add("name", surface.name);
    json.add_raw("x", values_json(surface.x));
    json.add_raw("y", values_json(surface.y));
    std::vector<std::string> rows;
    for (std::size_t row = 0; row < surface.y.size(); ++row) {
        const auto begin = surface.z.begin() + static_cast<std::ptrdiff_t>(row * surface.x.size());
        rows.push_back(values_json({begin, begin + static_cast<std::ptrdiff_t>(surface.x.size())}));
    }
    json.add_raw("z", json_array(rows));
    return json.text();
}

template <typename Things, typename ToJson>
void add_all(JsonObject& json, std::string_view name, const Things& things, const ToJson& to_json) {
    if (things.empty()) return;
    std::vector<std::string> all;
    for (const auto& thing : things) all.push_back(to_json(thing));
    json.add_raw(name, json_array(all));
}

void check_size(const Plot& plot) {
    std::size_t values = plot.marks.size();
    for (const PlotCurve& curve : plot.curves) values += curve.points.size();
    for (const PlotSurface& surface : plot.surfaces) values += surface.z.size();
    if (values > kMostToldValues)
        throw Error(Fault::usage, spelled("json"),
                    phrase("it tells {0} values at most, and the table has {1}; leave it out, or keep every tenth row, for "
                           "example: awk 'NR % 10 == 1' FILE",
                           std::to_string(kMostToldValues), std::to_string(values)));
}

}  // namespace

std::string chart_json(const Plot& plot, const ChartTold& told, const Sheet& sheet) {
    check_size(plot);
    const Place place = place_on(sheet, 1);
    JsonObject json;
    json.add("title", plot.title);
    const bool level = plot.bars && told.level;  // the axes change places
    json.add_raw("x", axis_json(level ? plot.y : plot.x, told.x, place.live.left));
    json.add_raw("y", axis_json(level ? plot.x : plot.y, told.y, place.drawing.top));
    if (!plot.z.name.empty()) json.add_raw("z", axis_json(plot.z, {}, 0));
    if (plot.bars) json.add_raw("bars", bars_json(*plot.bars, told));
    add_all(json, "curves", plot.curves, curve_json);
    add_all(json, "marks", plot.marks, [&](const PlotMark& mark) { return mark_json(mark, plot.spatial); });
    add_all(json, "surfaces", plot.surfaces, surface_json);
    return json.text();
}

}  // namespace tactics
