// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_found.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "tactics/haptics/scenes/near_lines.h"
#include "tactics/text/json.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kPassed = 3;  // mm from a place of the curve: the finger has been there
constexpr double kSame = 10;   // mm between two findings of one point
constexpr double kStride = 1;  // mm along the curve between examined places

Phrase to_step(double value, double step) { return numeral(std::round(value / step) * step); }

const HandFinding* find(const std::vector<HandFinding>& findings, std::string_view what) {
    const auto found = std::find_if(findings.begin(), findings.end(), [&](const HandFinding& one) { return one.what == what; });
    return found == findings.end() ? nullptr : &*found;
}

// Every millimetre of a line.
std::vector<Point> places_along(const std::vector<Point>& line) {
    std::vector<Point> places;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const int steps = std::max(1, static_cast<int>(distance(line[i], line[i + 1]) / kStride));
        for (int k = 0; k < steps; ++k)
            places.push_back(
                {line[i].x + (line[i + 1].x - line[i].x) * k / steps, line[i].y + (line[i + 1].y - line[i].y) * k / steps});
    }
    return places;
}

double to_line(const std::vector<Point>& line, Point at) {
    double least = INFINITY;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point a = line[i], way{line[i + 1].x - a.x, line[i + 1].y - a.y};
        const double squared = way.x * way.x + way.y * way.y;
        const double t = squared > 0 ? std::clamp(((at.x - a.x) * way.x + (at.y - a.y) * way.y) / squared, 0.0, 1.0) : 0;
        least = std::min(least, distance(at, {a.x + t * way.x, a.y + t * way.y}));
    }
    return least;
}

void tell_curve(const std::vector<HandFinding>& findings, const std::vector<TickRecord>& records, const Plot& plot,
                const PlotFrame& frame, HandReport& report, JsonObject& json) {
    const HandFinding* curve = find(findings, "curve");
    if (curve == nullptr) return;
    const HandFinding* closed = find(findings, "closed curve");
    const HandFinding* end = closed != nullptr ? closed : find(findings, "end of the curve");
    const FeltLines felt = felt_lines(plot, frame, 0.02);
    if (felt.lines.empty()) return;
    const auto by_distance = [&](const auto& a, const auto& b) {
        const Point at{curve->place.x, curve->place.y};
        return to_line(a, at) < to_line(b, at);
    };
    const std::vector<Point>& line = *std::min_element(felt.lines.begin(), felt.lines.end(), by_distance);
    const std::vector<Point> places = places_along(line);
    const NearLines near({line});
    std::vector<bool> passed(places.size());
    std::vector<double> off;
    // The hand's clock starts half a second after the play's; its findings are at places, which tell the ticks.
    const auto at_place = [](const HandFinding& finding, const TickRecord& one) {
        return distance(one.at, {finding.place.x, finding.place.y}) < 0.5;
    };
    auto from = std::find_if(records.begin(), records.end(), [&](const TickRecord& one) { return one.time >= curve->time; });
    for (std::size_t ticks = 0; from != records.end(); ++from, ++ticks) {
        if (end != nullptr && from->time > end->time && at_place(*end, *from)) break;
        const Nearness here = near.at({from->at.x, from->at.y, 0});
        off.push_back(here.within ? here.distance : to_line(line, from->at));
        if (ticks % 5 == 0)
            for (std::size_t k = 0; k < places.size(); ++k)
                if (!passed[k] && distance(places[k], from->at) < kPassed) passed[k] = true;
        if (end != nullptr && from->time > end->time + 0.7) break;
    }
    if (off.empty()) return;
    double squares = 0;
    for (const double one : off) squares += one * one;
    const double rms = std::sqrt(squares / static_cast<double>(off.size()));
    std::sort(off.begin(), off.end());
    const double most = off[off.size() * 95 / 100];
    const double share = static_cast<double>(std::count(passed.begin(), passed.end(), true)) / static_cast<double>(places.size());
    report.lines.push_back(phrase(
        "the hand found a curve after {0} s and followed {1} % of it, {2} mm off (root of the mean square), 95 % within {3} mm",
        to_step(curve->time, 0.1), to_step(100 * share, 1), to_step(rms, 0.01), to_step(most, 0.01)));
    json.add("curve_followed", share);
    json.add("curve_rms_mm", rms);
    json.add("curve_p95_mm", most);
    if (closed != nullptr) {
        report.lines.push_back(phrase("it took the curve to be closed"));
        json.add_raw("curve_closed", "true");
        return;
    }
    if (end == nullptr) return;
    const double missed =
        std::min(distance({end->place.x, end->place.y}, line.back()), distance({end->place.x, end->place.y}, line.front()));
    report.lines.push_back(phrase("it took the curve to end {0} mm from its end", to_step(missed, 0.1)));
    json.add("end_off_mm", missed);
}

void tell_tick(const std::vector<HandFinding>& findings, const Plot& plot, const PlotFrame& frame, HandReport& report,
               JsonObject& json) {
    const HandFinding* tick = find(findings, "tick");
    if (tick == nullptr || frame.x.ticks.empty()) return;
    const auto away = [&](double value) { return std::abs(frame.across(value) - tick->place.x); };
    const double nearest =
        *std::min_element(frame.x.ticks.begin(), frame.x.ticks.end(), [&](double a, double b) { return away(a) < away(b); });
    report.lines.push_back(
        phrase("it stopped at the tick {0} of {1}, {2} mm from it", numeral(nearest), plot.x.name, to_step(away(nearest), 0.1)));
    json.add("tick", nearest);
    json.add("tick_off_mm", away(nearest));
}

void tell_points(const std::vector<HandFinding>& findings, const Plot& plot, const PlotFrame& frame, HandReport& report,
                 JsonObject& json) {
    // One point is met in several rows: what lies together is one, in the middle.
    struct Group {
        Point sum;
        int count;
        Point middle() const { return {sum.x / count, sum.y / count}; }
    };
    std::vector<Group> groups;
    for (const HandFinding& one : findings) {
        if (one.what != "point") continue;
        const Point at{one.place.x, one.place.y};
        const auto same =
            std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return distance(g.middle(), at) < kSame; });
        if (same == groups.end())
            groups.push_back({at, 1});
        else
            same->sum = {same->sum.x + at.x, same->sum.y + at.y}, ++same->count;
    }
    if (groups.empty() || plot.marks.empty()) return;
    std::sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a.middle().y < b.middle().y; });
    std::vector<double> heights;
    for (const PlotMark& mark : plot.marks) heights.push_back(mark.y);
    std::sort(heights.begin(), heights.end(), std::greater<>());
    std::vector<Phrase> highest;
    std::size_t right = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, groups.size()); ++i) {
        const Point at = groups[i].middle();
        const PlotMark& nearest =
            *std::min_element(plot.marks.begin(), plot.marks.end(), [&](const PlotMark& a, const PlotMark& b) {
                return distance({frame.across(a.x), frame.down(a.y)}, at) < distance({frame.across(b.x), frame.down(b.y)}, at);
            });
        if (nearest.y >= heights[std::min<std::size_t>(2, heights.size() - 1)]) ++right;
        highest.push_back(phrase("{0} {1}", numeral(nearest.x), numeral(nearest.y)));
    }
    report.lines.push_back(
        phrase("the hand felt {0} points, of which there are {1}; the highest to it: {2} ({3} of the three highest)",
               std::to_string(groups.size()), std::to_string(plot.marks.size()), row_of(highest), std::to_string(right)));
    json.add("points_felt", static_cast<double>(groups.size()));
    json.add("highest_right", static_cast<double>(right));
}

// The shape of a section from its beginning to its end: +1 up to the middle and down again, -1 the opposite, 0 neither; and its
// slope.
struct Course {
    int bend = 0, slope = 0;
};
constexpr double kTold = 0.1;  // of the field's heights: less is level

// x: share of the section, from 0 to 1; y: height there.
Course course_of(const std::vector<Point>& heights, double whole) {
    if (heights.size() < 10 || !(whole > 0)) return {};
    // A hand does not reach the sides of a solid, so the same parts of each section are compared.
    const auto mean = [&](double from, double to) {
        double sum = 0;
        int count = 0;
        for (const Point& one : heights)
            if (one.x >= from && one.x <= to) sum += one.y, ++count;
        return count > 0 ? sum / count : 0;
    };
    const double begin = mean(0.08, 0.22), middle = mean(0.42, 0.58), end = mean(0.78, 0.92);
    const auto sign = [&](double by) { return std::abs(by) < kTold * whole ? 0 : by > 0 ? 1 : -1; };
    return {sign(middle - (begin + end) / 2), sign(end - begin)};
}

std::string shape_of(const Course& across, const Course& down) {
    if (across.bend != 0 && down.bend != 0) return across.bend != down.bend ? "saddle" : across.bend > 0 ? "hill" : "bowl";
    const int bend = across.bend != 0 ? across.bend : down.bend;
    if (bend != 0) return bend > 0 ? "ridge" : "valley";
    return across.slope != 0 || down.slope != 0 ? "slope" : "flat";
}

constexpr SourceWords kShapes[] = {"saddle", "hill", "bowl", "ridge", "valley", "slope", "flat"};
Phrase spoken(std::string_view shape) {
    const auto found = std::find_if(std::begin(kShapes), std::end(kShapes), [&](SourceWords one) { return one.text == shape; });
    return found == std::end(kShapes) ? Phrase(shape) : phrase(*found);
}

// The truth, from the numbers themselves: the row and the column in the middle, straight from value to value.
std::string true_shape(const PlotSurface& surface, const PlotFrame& frame) {
    const auto column = surface.x.size() / 2, row = surface.y.size() / 2;
    const auto between = [](std::vector<Point>& section, Point a, Point b) {
        constexpr int kSteps = 20;
        if (!std::isfinite(a.y) || !std::isfinite(b.y)) return;
        for (int k = 0; k < kSteps; ++k)
            section.push_back({a.x + (b.x - a.x) * (k + 0.5) / kSteps, a.y + (b.y - a.y) * (k + 0.5) / kSteps});
    };
    std::vector<Point> across, down;
    const auto of_row = [&](std::size_t i) { return Point{frame.across(surface.x[i]) / frame.width, surface.at(i, row)}; };
    const auto of_column = [&](std::size_t k) { return Point{frame.down(surface.y[k]) / frame.height, surface.at(column, k)}; };
    for (std::size_t i = 1; i < surface.x.size(); ++i) between(across, of_row(i - 1), of_row(i));
    for (std::size_t k = 1; k < surface.y.size(); ++k) between(down, of_column(k - 1), of_column(k));
    const double whole = frame.z.high - frame.z.low;
    return shape_of(course_of(across, whole), course_of(down, whole));
}

void tell_sections(const std::vector<HandFinding>& findings, const Plot& plot, const PlotFrame& frame, HandReport& report,
                   JsonObject& json) {
    std::vector<Point> across, down;
    for (const HandFinding& one : findings)
        if (one.what == "height across")
            across.push_back({one.place.x / frame.width, one.place.z});
        else if (one.what == "height down")
            down.push_back({one.place.y / frame.height, one.place.z});
    if (across.size() < 10 || down.size() < 10 || plot.surfaces.empty()) return;
    const std::string felt = shape_of(course_of(across, frame.depth), course_of(down, frame.depth));
    const std::string real = true_shape(plot.surfaces.front(), frame);
    report.lines.push_back(felt == real ? phrase("to the hand its two sections are those of a {0}, as they are", spoken(felt))
                                        : phrase("to the hand its two sections are those of a {0}; they are those of a {1}",
                                                 spoken(felt), spoken(real)));
    json.add("shape_felt", felt);
    json.add("shape", real);
}

}  // namespace

HandReport report_of(const std::vector<HandFinding>& findings, const std::vector<TickRecord>& records, const Plot& plot,
                     const PlotFrame& frame) {
    HandReport report;
    JsonObject json;
    tell_curve(findings, records, plot, frame, report, json);
    tell_tick(findings, plot, frame, report, json);
    tell_points(findings, plot, frame, report, json);
    tell_sections(findings, plot, frame, report, json);
    const std::string object = json.text();
    report.json = object.substr(1, object.size() - 2);
    return report;
}

}  // namespace tactics
