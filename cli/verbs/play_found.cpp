// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_found.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "cli/verbs/felt_shape.h"
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

// Between its rising values, as facets are; not a number outside and where one is missing.
double height_at(const PlotSurface& surface, double x, double y) {
    const auto cell_of = [](const std::vector<double>& values, double at) {
        std::size_t i = 1;
        while (i < values.size() && (values[i] - at) * (values[i - 1] - at) > 0) ++i;
        return i;
    };
    const std::size_t i = cell_of(surface.x, x), k = cell_of(surface.y, y);
    if (i >= surface.x.size() || k >= surface.y.size()) return NAN;
    const double u = (x - surface.x[i - 1]) / (surface.x[i] - surface.x[i - 1]),
                 v = (y - surface.y[k - 1]) / (surface.y[k] - surface.y[k - 1]);
    const auto mix = [](double a, double b, double share) { return share <= 0 ? a : share >= 1 ? b : a + share * (b - a); };
    return mix(mix(surface.at(i - 1, k - 1), surface.at(i, k - 1), u), mix(surface.at(i - 1, k), surface.at(i, k), u), v);
}

// The truth, from the numbers themselves.
std::pair<Section, Section> true_sections(const PlotSurface& surface, const PlotFrame& frame) {
    constexpr int kPlaces = 500;
    Section across, down;
    for (int n = 0; n < kPlaces; ++n) {
        const double share = (n + 0.5) / kPlaces;
        const auto take = [&](Section& section, double u, double v) {
            const Point3 at = frame.values({u * frame.width, v * frame.height, 0});
            const double height = height_at(surface, at.x, at.y);
            if (std::isfinite(height))
                section.heights.push_back({share, frame.depth * frame.z.share_of(height)});
            else
                section.bare.push_back(share);
        };
        take(across, share, 0.5);
        take(down, 0.5, share);
    }
    return {across, down};
}

struct Courses {
    std::string_view across, down;
    std::string_view shape() const { return shape_of(across, down); }
    Phrase spoken() const {
        return shape().empty() ? phrase("those of {0} across and {1} down", spoken_shape(across), spoken_shape(down))
                               : phrase("those of {0}", spoken_shape(shape()));
    }
};

void tell_sections(const std::vector<HandFinding>& findings, const Plot& plot, const PlotFrame& frame, HandReport& report,
                   JsonObject& json) {
    if (plot.surfaces.empty()) return;
    Section across, down;
    for (const HandFinding& one : findings) {
        const double x = one.place.x / frame.width, y = one.place.y / frame.height;
        if (one.what == "height across") across.heights.push_back({x, one.place.z});
        if (one.what == "height down") down.heights.push_back({y, one.place.z});
        if (one.what == "no ground across") across.bare.push_back(x);
        if (one.what == "no ground down") down.bare.push_back(y);
        if (one.what != "stuck") continue;
        const Point3 at = frame.values(one.place);
        report.lines.push_back(phrase("the hand did not get through the surface at {0} {1}", numeral(at.x), numeral(at.y)));
        json.add_raw("not_through_at", "[" + to_text(at.x) + "," + to_text(at.y) + "]");
    }
    const auto [real_across, real_down] = true_sections(plot.surfaces.front(), frame);
    const Courses felt{course_of(across, frame.depth), course_of(down, frame.depth)},
        real{course_of(real_across, frame.depth), course_of(real_down, frame.depth)};
    if (!real.shape().empty()) json.add("shape", std::string(real.shape()));
    if (felt.across.empty() || felt.down.empty()) {
        report.lines.push_back(phrase("the hand did not feel the whole of its two sections"));
        return;
    }
    report.lines.push_back(felt.spoken() == real.spoken()
                               ? phrase("to the hand its two sections are {0}, as they are", felt.spoken())
                               : phrase("to the hand its two sections are {0}; they are {1}", felt.spoken(), real.spoken()));
    json.add("section_across", std::string(felt.across));
    json.add("section_down", std::string(felt.down));
    if (!felt.shape().empty()) json.add("shape_felt", std::string(felt.shape()));
}

}  // namespace

HandReport report_of(const HandKind& kind, const Hand& hand, const std::vector<TickRecord>& records, const Plot& plot,
                     const PlotFrame& frame) {
    HandReport report;
    JsonObject json;
    const std::vector<HandFinding>& findings = hand.findings();
    tell_curve(findings, records, plot, frame, report, json);
    tell_tick(findings, plot, frame, report, json);
    tell_points(findings, plot, frame, report, json);
    if (kind.name == "sections") tell_sections(findings, plot, frame, report, json);
    if (kind.name == "trace" && find(findings, "curve") == nullptr) {
        report.lines.push_back(phrase("the hand found no curve"));
        json.add_raw("curve_found", "false");
    }
    if (kind.name == "trace" && hand.is_done() && find(findings, "curve") != nullptr && find(findings, "tick") == nullptr)
        report.lines.push_back(phrase("it found no tick"));
    if (kind.name == "points" && find(findings, "point") == nullptr) {
        report.lines.push_back(phrase("the hand felt no point"));
        json.add("points_felt", 0.0);
    }
    if (kind.ends && !hand.is_done())
        report.lines.push_back(phrase("the hand was still under way when the seconds ended; give it more (--seconds)"));
    if (kind.ends) json.add_raw("hand_ended", hand.is_done() ? "true" : "false");
    const std::string object = json.text();
    report.json = object.substr(1, object.size() - 2);
    return report;
}

}  // namespace tactics
