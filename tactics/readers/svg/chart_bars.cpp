// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/chart_bars.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "tactics/geometry/bars_on_base.h"
#include "tactics/geometry/box.h"
#include "tactics/readers/svg/line_hatches.h"

namespace tactics {

namespace {

// mm of a figure that is 200 mm wide or high; settings.
constexpr double kSquare = 0.1;   // what corners of a rectangle are off at most
constexpr double kSameBar = 0.6;  // a surface, and the line around it
constexpr BarSlack kSvgSlack{0.8, 1.2};
constexpr double kLowestBar = 0.1, kTallestBar = 12, kMostOfFigure = 0.5, kOverlap = 1;
constexpr double kWhiteFill = 0.95;  // as in Paint::is_seen
constexpr std::size_t kMostKinds = 6, kMostRectangles = 2000, kMostBars = 200;

// What is drawn at one place.
struct BarCandidate {
    Box box;
    double fill = -1;                // as in FoundLook
    std::vector<std::size_t> looks;  // numbers
};

std::optional<Box> rectangle_of(const std::vector<Point>& points) {
    if (points.size() < 4 || points.size() > 5) return std::nullopt;
    const Box box = box_of(points);
    std::array<bool, 4> corners{};
    for (const Point& p : points) {
        const bool left = p.x - box.left < kSquare, right = box.right - p.x < kSquare, top = p.y - box.top < kSquare,
                   bottom = box.bottom - p.y < kSquare;
        if (!(left || right) || !(top || bottom)) return std::nullopt;
        corners[(left ? 0u : 1u) + (top ? 0u : 2u)] = true;
    }
    return std::all_of(corners.begin(), corners.end(), [](bool there) { return there; }) ? std::optional(box) : std::nullopt;
}

// Nothing where there is anything else in it.
std::vector<Box> rectangles_of(const FoundPage& figure, const FoundLook& look) {
    std::vector<Box> boxes;
    const auto add = [&](const std::vector<Point>& points) {
        const auto box = rectangle_of(points);
        if (box) boxes.push_back(*box);
        return box.has_value();
    };
    for (std::size_t i = look.stroke; i < look.strokes_end; ++i)
        if (!figure.page.strokes[i].closed || !add(figure.page.strokes[i].points)) return {};
    for (std::size_t i = look.area; i < look.areas_end && look.stroke == look.strokes_end; ++i)
        for (const auto& ring : figure.page.areas[i].rings)
            if (!add(ring)) return {};
    return boxes;
}

bool is_white(double fill) { return fill < 0 || (fill >= kWhiteFill && fill <= 1); }

std::vector<BarCandidate> candidates_in(const FoundPage& figure) {
    std::vector<BarCandidate> all;
    for (std::size_t i = 0; i < figure.looks.size() && all.size() < kMostRectangles; ++i) {
        const FoundLook& look = figure.looks[i];
        for (const Box& box : rectangles_of(figure, look)) {
            if (box.width() * box.height() > kMostOfFigure * figure.page.width * figure.page.height) continue;
            if (std::min(box.width(), box.height()) < kLowestBar) continue;
            auto same = std::find_if(all.begin(), all.end(), [&](const auto& one) { return same_box(one.box, box, kSameBar); });
            if (same == all.end()) same = all.insert(same, {box, -1, {}});
            if (same->fill < 0 || !is_white(look.fill)) same->fill = look.fill;
            same->looks.push_back(i);
        }
    }
    return all;
}

// What two of them share is more than their outlines.
bool any_overlap(const std::vector<ChartBar>& bars) {
    for (std::size_t i = 0; i < bars.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Box &a = bars[i].box, &b = bars[j].box;
            if (std::min(a.right, b.right) - std::max(a.left, b.left) > kOverlap &&
                std::min(a.bottom, b.bottom) - std::max(a.top, b.top) > kOverlap)
                return true;
        }
    return false;
}

// A line of something else along the base, beyond the first bar or the last one.
bool has_axis(const FoundPage& figure, const ChartBars& found) {
    Box all = kNothing;
    for (const ChartBar& bar : found.bars) {
        all.take({bar.box.left, bar.box.top});
        all.take({bar.box.right, bar.box.bottom});
    }
    const auto across = [&](Point p) { return found.lying ? p.x : p.y; };
    const auto along = [&](Point p) { return found.lying ? p.y : p.x; };
    const double first = found.lying ? all.top : all.left, last = found.lying ? all.bottom : all.right;
    const auto goes_on = [&](Point a, Point b) {
        if (std::max(std::abs(across(a) - found.base), std::abs(across(b) - found.base)) > kSvgSlack.touch) return false;
        const auto [from, to] = std::minmax({along(a), along(b)});
        return from < first + kSvgSlack.touch && to > last - kSvgSlack.touch &&
               (from < first - kSvgSlack.touch || to > last + kSvgSlack.touch);
    };
    return std::any_of(figure.page.strokes.begin(), figure.page.strokes.end(), [&](const PageStroke& stroke) {
        const auto& points = stroke.points;
        for (std::size_t i = 1; i < points.size() + (stroke.closed ? 1 : 0); ++i)
            if (goes_on(points[i - 1], points[i % points.size()])) return true;
        return false;
    });
}

std::size_t kind_of(double fill, std::vector<double>& fills) {
    const auto same = std::find(fills.begin(), fills.end(), fill);
    if (same != fills.end()) return static_cast<std::size_t>(same - fills.begin());
    fills.push_back(fill);
    return fills.size() - 1;
}

BarPaint paint_of(double fill) {
    constexpr double kDarkOfHatch = 0.5;  // it is not known
    if (is_white(fill)) return {true, false, 0};
    return fill > 1 ? BarPaint{false, true, kDarkOfHatch} : BarPaint{false, false, 1 - fill};
}

std::optional<ChartBars> bars_among(const std::vector<BarCandidate>& candidates, const BarsOnBase& chosen) {
    if (chosen.bars.empty() || chosen.bars.size() > kMostBars || stand_as_boxes(chosen.bars, kSvgSlack.touch))
        return std::nullopt;
    ChartBars found;
    found.lying = chosen.lying;
    found.base = chosen.place();
    std::vector<double> fills;
    double tallest = 0;
    for (const StandingBar& bar : chosen.bars) {
        const double fill = candidates[bar.number].fill;
        tallest = std::max(tallest, bar.foot - bar.top);
        found.bars.push_back({as_it_lies(bar, chosen.lying), kind_of(is_white(fill) ? -1 : fill, fills)});
    }
    if (fills.size() > kMostKinds || tallest < kTallestBar || any_overlap(found.bars)) return std::nullopt;
    for (const double fill : fills) found.looks.push_back(paint_of(fill));
    return found;
}

}  // namespace

void find_chart_bars(FoundPage& figure) {
    std::vector<BarCandidate> candidates = candidates_in(figure);
    std::vector<Box> boxes;
    for (const BarCandidate& one : candidates) boxes.push_back(one.box);
    const std::vector<LineHatch> hatches = line_hatches_in(figure, boxes);
    std::vector<BarRectangle> rectangles;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (hatches[i].number > 0 && is_white(candidates[i].fill)) {
            candidates[i].fill = hatches[i].number;
            for (const std::size_t look : candidates[i].looks) figure.looks[look].fill = hatches[i].number;
        }
        rectangles.push_back({candidates[i].box, is_white(candidates[i].fill)});
    }
    const BarsOnBase chosen = bars_on_base(rectangles, kSvgSlack);
    figure.bars = bars_among(candidates, chosen);
    if (!figure.bars) return;
    figure.bars->on_axis = has_axis(figure, *figure.bars);
    // Those of the samples of a legend, too, which would be taken for samples of lines.
    for (const LineHatch& hatch : hatches)
        for (const std::size_t stroke : hatch.strokes) figure.page.strokes[stroke].points.clear();
}

bool outlines_bar(const ChartBars& bars, const std::vector<Point>& line) {
    return !line.empty() && std::any_of(bars.bars.begin(), bars.bars.end(), [&](const ChartBar& bar) {
        return std::all_of(line.begin(), line.end(), [&](Point p) {
            if (!grown(bar.box, kSameBar).holds(p)) return false;
            const double off = std::min({std::abs(p.x - bar.box.left), std::abs(p.x - bar.box.right), std::abs(p.y - bar.box.top),
                                         std::abs(p.y - bar.box.bottom)});
            return off < kSameBar;
        });
    });
}

}  // namespace tactics
