#include "cli/play_report.h"

#include <algorithm>
#include <cmath>

#include "cli/json.h"
#include "tactics/units.h"

namespace tactics {

namespace {

std::string rounded(double value, double step) { return to_text(std::round(value / step) * step); }

}  // namespace

PlayFigures figures_of(const std::vector<TickRecord>& records, const LoopReport& loop, const Safety& safety, unsigned resets, unsigned gone, bool before_others, bool real) {
    PlayFigures figures;
    figures.ticks = records.size();
    figures.seconds = loop.seconds;
    std::size_t touched = 0;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const TickRecord& one = records[i];
        if (i > 0) figures.way += distance(one.at, records[i - 1].at);
        touched += one.force != 0 ? 1 : 0;
        figures.most_force = std::max(figures.most_force, std::abs(one.force));
        if (one.force > 0) figures.most_over = std::max(figures.most_over, one.finger - one.surface);
        figures.most_under = std::max(figures.most_under, one.surface - one.finger);
    }
    figures.touched = records.empty() ? 0 : static_cast<double>(touched) / static_cast<double>(records.size());
    figures.real = real;
    figures.before_others = before_others;
    figures.late_p50 = loop.lateness.quantile(0.5);
    figures.late_p99 = loop.lateness.quantile(0.99);
    figures.late_p999 = loop.lateness.quantile(0.999);
    figures.long_periods = loop.long_periods;
    figures.not_finite = safety.not_finite();
    figures.too_late = safety.too_late();
    figures.resets = resets;
    figures.gone = gone;
    return figures;
}

std::vector<std::string> figure_lines(const PlayFigures& f, bool lost) {
    std::vector<std::string> lines;
    lines.push_back(std::to_string(f.ticks) + " ticks in " + rounded(f.seconds, 0.001) + " s, " + rounded(f.way, 0.1) + " mm of way, touched in " + rounded(100 * f.touched, 0.1) +
                    " % of them; at most " + rounded(f.most_force, 0.01) + " N, the finger at most " + rounded(f.most_under, 0.01) + " mm in the surface");
    if (f.real)
        lines.push_back("late by " + rounded(1e6 * f.late_p50, 0.1) + " us (half of the ticks), " + rounded(1e6 * f.late_p99, 0.1) + " us (99 %), " + rounded(1e6 * f.late_p999, 0.1) +
                        " us (99.9 %); " + std::to_string(f.long_periods) + " periods over 5/4; " + (f.before_others ? "before all other programs (SCHED_FIFO)" : "as any other program (SCHED_OTHER)"));
    if (f.not_finite + f.too_late + f.resets + f.gone > 0)
        lines.push_back(std::to_string(f.not_finite) + " forces were not numbers, " + std::to_string(f.too_late) + " ticks came too late, the place was lost " +
                        std::to_string(f.resets) + " times, the mouse " + std::to_string(f.gone) + " times");
    if (lost) lines.push_back("the log holds the last " + std::to_string(f.ticks) + " ticks only");
    return lines;
}

std::string figures_json(const PlayFigures& f) {
    JsonObject json;
    json.add("ticks", static_cast<double>(f.ticks));
    json.add("seconds", f.seconds);
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
        json.add("scheduler", f.before_others ? "fifo" : "other");
    }
    json.add("not_finite", f.not_finite);
    json.add("too_late", f.too_late);
    json.add("resets", f.resets);
    json.add("gone", f.gone);
    return json.text();
}

Plot way_plot(const std::vector<TickRecord>& records) {
    constexpr std::size_t kMostPoints = 400;  // no page shows more
    Plot plot{"Fingertip over the surface", {"place, mm", false}, {"height, mm", false}, {}, {}};
    // Along the axis that it moves along most, up to where it first turns round.
    double left = 0, right = 0, top = 0, bottom = 0;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const Point at = records[i].at;
        left = i == 0 ? at.x : std::min(left, at.x);
        right = i == 0 ? at.x : std::max(right, at.x);
        top = i == 0 ? at.y : std::min(top, at.y);
        bottom = i == 0 ? at.y : std::max(bottom, at.y);
    }
    const bool across = right - left >= bottom - top;
    const auto place = [&](const TickRecord& one) { return across ? one.at.x : one.at.y; };
    std::size_t end = 1;
    const double way = across ? right - left : bottom - top;
    for (double farthest = records.empty() ? 0 : place(records[0]), sign = 0; end < records.size(); ++end) {
        const double moved = place(records[end]) - farthest;
        if (sign == 0 && std::abs(moved) > 0.01 * way) sign = moved > 0 ? 1 : -1;
        if (sign * moved > 0) farthest = place(records[end]);
        if (sign != 0 && sign * moved < -0.01 * way) break;
    }
    PlotCurve surface{"surface", {}}, finger{"fingertip", {}};
    const std::size_t step = std::max<std::size_t>(1, end / kMostPoints);
    for (std::size_t i = 0; i < std::min(end, records.size()); i += step) {
        surface.points.push_back({place(records[i]), records[i].surface});
        finger.points.push_back({place(records[i]), records[i].finger});
    }
    plot.curves = {std::move(surface), std::move(finger)};
    return plot;
}

}  // namespace tactics
