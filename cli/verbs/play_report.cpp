// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_report.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "tactics/error.h"
#include "tactics/text/json.h"
#include "tactics/units.h"

namespace tactics {

namespace {

bool moves(const std::vector<TickRecord>& records, std::size_t i) {
    return i > 0 && distance(records[i].truth, records[i - 1].truth) > 0;
}

// Whether some record has a known truth that differs from the reported position.
bool tells_truth(const std::vector<TickRecord>& records) {
    return std::any_of(records.begin(), records.end(),
                       [](const TickRecord& one) { return std::isfinite(one.truth.x) && distance(one.truth, one.at) > 0; });
}

std::optional<double> place_error(const std::vector<TickRecord>& records) {
    if (!tells_truth(records)) return std::nullopt;
    double squares = 0;
    std::size_t count = 0;
    for (std::size_t i = 1; i < records.size(); ++i) {
        if (!moves(records, i)) continue;
        const double away = distance(records[i].at, records[i].truth);
        squares += away * away;
        ++count;
    }
    return count > 0 ? std::optional(std::sqrt(squares / static_cast<double>(count))) : std::nullopt;
}

}  // namespace

PlayFigures figures_of(const std::vector<TickRecord>& records, const PlayLoopReport& played, const Playing& play,
                       const ForceLaw& law, const Lateness& updates, unsigned resets, bool before_others, bool real) {
    const LoopReport& loop = played.loop;
    PlayFigures figures;
    figures.law = law;
    figures.ticks = records.size();
    figures.seconds = loop.seconds;
    std::size_t touched = 0;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const TickRecord& one = records[i];
        if (i > 0) figures.way += distance(one.at, records[i - 1].at);
        touched += one.force != Point3{} ? 1 : 0;
        figures.most_force = std::max(figures.most_force, length_of(one.force));
        if (one.force.z > 0) figures.most_over = std::max(figures.most_over, one.finger - one.surface);
        figures.most_under = std::max(figures.most_under, one.surface - one.finger);
    }
    figures.place_error = place_error(records);
    figures.touched = records.empty() ? 0 : static_cast<double>(touched) / static_cast<double>(records.size());
    figures.real = real;
    figures.before_others = before_others;
    figures.late_p50 = loop.lateness.quantile(0.5);
    figures.late_p99 = loop.lateness.quantile(0.99);
    figures.late_p999 = loop.lateness.quantile(0.999);
    figures.long_periods = loop.long_periods;
    figures.update_p50 = updates.quantile(0.5);
    figures.update_p999 = updates.quantile(0.999);
    figures.not_finite = play.safety().not_finite();
    figures.too_late = play.safety().too_late();
    figures.resets = resets;
    figures.gone = played.gone;
    figures.reports_lost = play.reports_lost();
    return figures;
}

std::vector<Phrase> figure_lines(const PlayFigures& f, bool lost) {
    const auto in_steps = [](double value, double step) { return numeral(std::round(value / step) * step); };
    const auto us = [&](double seconds, double step) { return in_steps(1e6 * seconds, step); };
    std::vector<Phrase> lines;
    lines.push_back(
        phrase("{0} ticks in {1} s, {2} mm of way, touched in {3} % of them; at most {4} N, the finger at most {5} mm "
               "in the surface",
               std::to_string(f.ticks), in_steps(f.seconds, 0.001), in_steps(f.way, 0.1), in_steps(100 * f.touched, 0.1),
               in_steps(f.most_force, 0.01), in_steps(f.most_under, 0.01)));
    if (f.real)
        lines.push_back(phrase(
            "late by {0} us (half of the ticks), {1} us (99 %), {2} us (99.9 %); {3} periods over 5/4; {4}; what is felt "
            "answered in {5} us (half of the ticks), {6} us (99.9 %)",
            us(f.late_p50, 0.1), us(f.late_p99, 0.1), us(f.late_p999, 0.1), std::to_string(f.long_periods),
            f.before_others ? phrase("before all other programs (SCHED_FIFO)") : phrase("as any other program (SCHED_OTHER)"),
            us(f.update_p50, 0.01), us(f.update_p999, 0.01)));
    if (f.place_error)
        lines.push_back(
            phrase("the place was wrong by {0} mm while it moved (root of the mean square)", in_steps(*f.place_error, 0.01)));
    if (f.not_finite + f.too_late + f.resets + f.gone > 0)
        lines.push_back(
            phrase("{0} forces were not numbers, {1} ticks came too late, the place was lost {2} times, the mouse {3} times",
                   std::to_string(f.not_finite), std::to_string(f.too_late), std::to_string(f.resets), std::to_string(f.gone)));
    if (f.reports_lost > 0)
        lines.push_back(phrase("{0} reports of the mouse never came; its way is too short by what they told",
                               std::to_string(f.reports_lost)));
    if (lost) lines.push_back(phrase("figures and drawings are of the last {0} ticks only", std::to_string(f.ticks)));
    return lines;
}

std::string figures_json(const PlayFigures& f) {
    JsonObject json;
    json.add("ticks", static_cast<double>(f.ticks));
    json.add("seconds", f.seconds);
    json.add("stiffness_n_per_mm", f.law.stiffness);
    json.add("damping_ns_per_m", f.law.damping_ns_per_m);
    json.add("way_mm", f.way);
    json.add("touched", f.touched);
    json.add("most_force_n", f.most_force);
    json.add("most_in_surface_mm", f.most_under);
    json.add("most_over_surface_mm", f.most_over);
    if (f.real) {
        json.add("late_p50_us", 1e6 * f.late_p50);
        json.add("late_p99_us", 1e6 * f.late_p99);
        json.add("late_p999_us", 1e6 * f.late_p999);
        json.add("long_periods", static_cast<double>(f.long_periods));
        json.add("update_p50_us", 1e6 * f.update_p50);
        json.add("update_p999_us", 1e6 * f.update_p999);
        json.add("scheduler", f.before_others ? "fifo" : "other");
    }
    if (f.place_error) json.add("place_error_mm", *f.place_error);
    json.add("not_finite", f.not_finite);
    json.add("too_late", f.too_late);
    json.add("resets", f.resets);
    json.add("gone", f.gone);
    json.add("reports_lost", f.reports_lost);
    return json.text();
}

namespace {

constexpr std::size_t kMostPoints = 20'000;  // many more than a page shows; a chart keeps those that matter

// The axis that it moves along most.
bool goes_across(const std::vector<TickRecord>& records) {
    double left = 0, right = 0, top = 0, bottom = 0;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const Point at = records[i].at;
        left = i == 0 ? at.x : std::min(left, at.x);
        right = i == 0 ? at.x : std::max(right, at.x);
        top = i == 0 ? at.y : std::min(top, at.y);
        bottom = i == 0 ? at.y : std::max(bottom, at.y);
    }
    return right - left >= bottom - top;
}

// Up to where it first turns round.
std::size_t first_turn(const std::vector<double>& places) {
    if (places.empty()) return 0;
    const auto [least, most] = std::minmax_element(places.begin(), places.end());
    const double turned = 0.01 * (*most - *least);
    double farthest = places[0], sign = 0;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double moved = places[i] - farthest;
        if (sign == 0 && std::abs(moved) > turned) sign = moved > 0 ? 1 : -1;
        if (sign * moved > 0) farthest = places[i];
        if (sign != 0 && sign * moved < -turned) return i;
    }
    return places.size();
}

}  // namespace

Plot way_plot(const std::vector<TickRecord>& records, const ReliefSurface& map, std::optional<Point> part, bool repeats) {
    Plot plot{"Fingertip over the surface", {"place, mm", false}, {"height, mm", false}, {}, {}};
    const bool across = goes_across(records);
    const auto at = [](const TickRecord& one) { return std::isfinite(one.truth.x) ? one.truth : one.at; };
    std::vector<double> places;
    for (const TickRecord& one : records) places.push_back(across ? at(one).x : at(one).y);
    std::size_t end = first_turn(places);
    // A path that returns over itself is drawn with one pass after another.
    if (!part && !repeats && end < records.size()) {
        plot.x.name = "way, mm";
        double way = 0;
        for (std::size_t i = 0; i < records.size(); ++i)
            places[i] = way += i > 0 ? distance(at(records[i]), at(records[i - 1])) : 0;
        end = records.size();
    }
    // While the hand still rests the force begins softly, and the finger falls and comes back at one place.
    std::size_t begin = 0;
    while (begin + 1 < end && distance(at(records[begin]), at(records[begin + 1])) == 0) ++begin;
    // Where the two are too close to be told apart, only the first is drawn, because it is the subject of the play.
    PlotCurve finger{"fingertip", {}}, surface{"surface", {}};
    const std::size_t step = part ? 1 : std::max<std::size_t>(1, (end - begin) / kMostPoints);
    for (std::size_t i = begin; i < end; i += step) {
        if (part && !(places[i] >= part->x && places[i] <= part->y)) continue;
        surface.points.push_back({places[i], map.height(at(records[i]))});
        finger.points.push_back({places[i], records[i].finger});
    }
    if (part && places.empty()) throw Error(Fault::usage, "--part", phrase("nothing was played that it could be of"));
    if (part && surface.points.size() < 2) {
        const auto [least, most] = std::minmax_element(places.begin(), places.end());
        throw Error(Fault::usage, "--part",
                    phrase("the first way over the map has nothing there; it goes from {0} to {1} mm",
                           numeral(std::round(*least * 10) / 10), numeral(std::round(*most * 10) / 10)));
    }
    plot.curves = {std::move(finger), std::move(surface)};
    return plot;
}

Plot track_plot(const std::vector<TickRecord>& records) {
    Plot plot{"Where the fingertip is", {"time, s", false}, {"place, mm", false}, {}, {}};
    const bool across = goes_across(records);
    const auto along = [&](Point at) { return across ? at.x : at.y; };
    std::size_t end = records.size(), begin = end;
    const auto back = [&](std::size_t from, bool moving) {
        while (from > 0 && moves(records, from - 1) == moving) --from;
        return from;
    };
    // An unfinished pass does not show its end; a finished one is followed by a rest.
    if (const std::size_t rest = back(end, true); rest > 0 && back(rest, false) > 0) end = rest;
    begin = back(back(end, false), true);
    if (end - begin < 2)
        throw Error(Fault::usage, "--track", phrase("no way was ended in that time; give it more with --seconds"));
    PlotCurve truth{"where it is", {}}, told{"where the mouse takes it to be", {}};
    const std::size_t step = std::max<std::size_t>(1, (end - begin) / kMostPoints);
    for (std::size_t i = begin; i < end; i += step) {
        const double time = records[i].time - records[begin].time;
        truth.points.push_back({time, along(records[i].truth)});
        told.points.push_back({time, along(records[i].at)});
    }
    plot.curves = {std::move(truth), std::move(told)};
    return plot;
}

StableFigures stable_figures(const ForceLaw& law, const LeverSettings& lever, std::span<const FingerSettings> fingers,
                             bool stable) {
    constexpr double kLeastShown = 8, kStep = 0.5;  // N s/m
    constexpr int kMost = 65;
    const double most = std::max(kLeastShown, std::ceil(1.25 * law.damping_ns_per_m));
    const int count = std::min(kMost, static_cast<int>(most / kStep) + 1);
    return {law, lever, stable, stable_region(most, count, law.sign, lever, fingers)};
}

Plot stable_plot(const StableFigures& figures) {
    Plot plot{"Stable stiffness at " + to_text(figures.lever.rate_hz) + " Hz",
              {"damping, N s/m", false},
              {"stiffness, N/mm", false},
              {},
              {}};
    PlotCurve border{"the most that comes to rest", {}};
    for (const StablePoint& point : figures.border) border.points.push_back({point.damping_ns_per_m, point.stiffness});
    plot.curves = {std::move(border)};
    plot.marks.push_back({figures.stable ? "asked for, comes to rest" : "asked for, swings on", figures.law.damping_ns_per_m,
                          figures.law.stiffness, figures.stable ? PlotSymbol::disc : PlotSymbol::ring});
    return plot;
}

std::string stable_json(const StableFigures& figures) {
    std::vector<std::string> border;
    for (const StablePoint& point : figures.border) {
        JsonObject one;
        one.add("damping_ns_per_m", point.damping_ns_per_m);
        one.add("stiffness_n_per_mm", point.stiffness);
        border.push_back(one.text());
    }
    JsonObject json;
    json.add("rate_hz", figures.lever.rate_hz);
    json.add("delay_s", figures.lever.delay);
    json.add("damping_ns_per_m", figures.law.damping_ns_per_m);
    json.add("stiffness_n_per_mm", figures.law.stiffness);
    json.add_raw("stable", figures.stable ? "true" : "false");
    json.add_raw("most", json_array(border));
    return json.text();
}

}  // namespace tactics
