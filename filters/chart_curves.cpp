// SPDX-License-Identifier: Apache-2.0
#include "filters/chart_curves.h"

#include <algorithm>
#include <cmath>

#include "filters/curves_apart.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

using Line = std::vector<Point>;

constexpr std::size_t kMany = 4000;  // points of a curve: more than a page is wide in quarters of a millimetre, several times

std::vector<Line> runs_of(const PlotCurve& curve, const AxisScale& across, const AxisScale& up) {
    std::vector<Line> runs(1);
    std::size_t gap = 0;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        while (gap < curve.gaps.size() && curve.gaps[gap] < i) ++gap;
        if (gap < curve.gaps.size() && curve.gaps[gap] == i && !runs.back().empty()) runs.emplace_back();
        runs.back().push_back({across.at(curve.points[i].x), up.at(curve.points[i].y)});
    }
    return runs;
}

Line joined(const Line& run, Joining how) {
    if (how == Joining::straight) return run;
    Line line;
    for (const Point& p : run) {
        if (!line.empty() && line.back().y != p.y) line.push_back({p.x, line.back().y});
        line.push_back(p);
    }
    return line;
}

bool goes_right(const std::vector<Line>& runs) {
    return std::all_of(runs.begin(), runs.end(), [](const Line& run) {
        return std::is_sorted(run.begin(), run.end(), [](Point a, Point b) { return a.x < b.x; });
    });
}

// The first and the last point, and of each stretch of that length in between the one with the middle value.
Line thinned(const Line& run, double every) {
    if (run.size() < 4) return run;
    Line line{run.front()}, stretch;
    const auto take = [&] {
        if (stretch.empty()) return;
        const auto middle = stretch.begin() + static_cast<std::ptrdiff_t>(stretch.size() / 2);
        std::nth_element(stretch.begin(), middle, stretch.end(),
                         [](Point a, Point b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
        line.push_back(*middle);
        stretch.clear();
    };
    double number = 0;
    for (std::size_t i = 1; i + 1 < run.size(); ++i) {
        const double now = std::floor((run[i].x - run.front().x) / every);
        if (now != number) take();
        number = now;
        stretch.push_back(run[i]);
    }
    take();
    line.push_back(run.back());
    return line;
}

ChartCurve lines_on(const PlotCurve& curve, const std::vector<Line>& runs, const Medium& medium) {
    ChartCurve best;
    std::size_t fewest = 0;
    const bool right = goes_right(runs), many = curve.points.size() > kMany;
    const ApartWish wish{medium.gap, 0, has_fixed_dots(medium) ? kTwoRows : 0, {}};
    for (const double every : {0.0, 0.25, 1.5, 3.0, 4.5, 6.0, 9.0, 12.0}) {
        if (every > 0 && !right) break;
        if ((every == 0 && right && many) || (every == 0.25 && !many)) continue;
        ChartCurve found;
        found.every = every;
        for (const Line& run : runs) {
            if (run.size() == 1) found.alone.push_back(run[0]);
            if (run.size() > 1) found.lines.push_back(joined(every > 0 ? thinned(run, every) : run, curve.joined));
        }
        if (!right) return found;
        const std::size_t pieces = curves_apart({{found.lines, medium.line}}, wish)[0].size();
        if (best.lines.empty() || pieces < fewest) {
            best = std::move(found);
            fewest = pieces;
        }
        if (fewest <= best.lines.size()) break;
    }
    return best;
}

ChartCurve bars_on(const std::vector<Line>& runs, double base, const Medium& medium) {
    ChartCurve found;
    const double least = least_apart(medium, medium.line, medium.line);
    for (const Line& run : runs) {
        if (run.size() < 2) continue;
        Line outline{{run[0].x, base}};
        for (std::size_t i = 0; i + 1 < run.size(); ++i) {
            const double left = run[i].x, right = run[i + 1].x, top = run[i].y;
            if (right - left < least)
                throw Error(Fault::usage, "",
                            phrase("its bars would be {0} mm wide, and a finger needs {1}; take fewer bars or larger paper",
                                   numeral(std::round(std::abs(right - left) * 10) / 10), numeral(least)));
            outline.push_back({left, top});
            outline.push_back({right, top});
            const double low = std::max(top, i > 0 ? run[i - 1].y : base), high = std::min(top, i > 0 ? run[i - 1].y : base);
            // A side that two bars share reaches from what they stand on to the nearer of their ends.
            const double inner = top < base ? low : high;
            if (i > 0 && (top < base) == (run[i - 1].y < base) && inner != base)
                found.lines.push_back({{left, base}, {left, inner}});
            if (top != base && std::abs(top - base) < least)
                found.filled.push_back({{left, base}, {left, top}, {right, top}, {right, base}});
        }
        outline.push_back({run.back().x, base});
        found.lines.push_back(std::move(outline));
        found.lines.push_back({{run.front().x, base}, {run.back().x, base}});
    }
    return found;
}

}  // namespace

ChartCurve curve_on(const PlotCurve& curve, const AxisScale& across, const AxisScale& up, bool up_is_logarithmic,
                    const Medium& medium) {
    const std::vector<Line> runs = runs_of(curve, across, up);
    if (curve.joined == Joining::bars) return bars_on(runs, up.at(up_is_logarithmic ? up.low() : 0), medium);
    return lines_on(curve, runs, medium);
}

}  // namespace tactics
