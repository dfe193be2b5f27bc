// SPDX-License-Identifier: Apache-2.0
#include "filters/chart_contours.h"

#include <algorithm>
#include <cmath>

#include "filters/contour_lines.h"
#include "tactics/geometry/box.h"
#include "tactics/geometry/places.h"
#include "tactics/geometry/shape.h"
#include "tactics/geometry/walk.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kHardToTell = 6;        // mm from one line to the next
constexpr double kContourStep = 1.5;     // mm from one place that is looked at to the next
constexpr double kLeastLineLeft = 12.7;  // mm of a line that is broken: half an inch (rules/line_length.cpp)
constexpr int kIndexEvery = 5;

std::vector<Point> even_places(const std::vector<Point>& line) {
    std::vector<Point> places;
    Walk walk(line, false);
    const double length = length_of(line, false);
    for (double along = 0; along < length; along += kContourStep) places.push_back(walk.to(along));
    return places;
}

std::vector<ChartLevel> lines_of(const PlotSurface& surface, const AxisScale& across, const AxisScale& up,
                                 const std::vector<double>& heights, const Axis& axis) {
    std::vector<ChartLevel> levels;
    const double step = heights.size() > 1 ? heights[1] - heights[0] : 0;
    for (const double height : heights) {
        const double number = step > 0 ? std::round(height / step) : 1;
        ChartLevel level{number_text(axis, height), heights.size() >= kIndexEvery && std::fmod(number, kIndexEvery) == 0, {}};
        for (const ContourLine& line : contour_lines(surface, height)) {
            std::vector<Point> points;
            for (const PlotPoint& p : line.points) points.push_back({across.at(p.x), up.at(p.y)});
            if (line.closed) points.push_back(points.front());
            level.lines.push_back(std::move(points));
        }
        levels.push_back(std::move(level));
    }
    return levels;
}

// Words in a break of one of the level's lines that is long enough for that, where no other line is near: a finger must know
// which line they belong to.
void label_levels(std::vector<ChartLevel>& levels, const LevelGround& ground) {
    const auto& [field, sheet, cells, all_clear, axis] = ground;
    const Clearance& clear = all_clear;  // Clang 14 captures no names of a structured binding
    std::vector<std::vector<Point>> places(levels.size());
    for (std::size_t i = 0; i < levels.size(); ++i)
        for (const auto& line : levels[i].lines)
            for (const Point& p : even_places(line)) places[i].push_back(p);
    std::vector<Rect> taken;
    // Words of the fewest lines have the fewest places.
    std::vector<std::size_t> order(levels.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return places[a].size() < places[b].size(); });
    for (const std::size_t number : order) {
        ChartLevel& level = levels[number];
        const LabelBlock block = set_label(level.words, sheet);
        double fewest = INFINITY;
        for (const auto& line : level.lines) {
            const std::vector<Point> own = even_places(line);
            const double length = length_of(line, false);
            for (const Point& at : own) {
                const Point corner = cells.nearest({at.x - block.width / 2, at.y - block.height / 2}, block);
                const Rect words{corner.x, corner.y, block.width, block.height}, kept = kept_by(words, clear);
                if (kept.left < field.left || kept.top < field.top || kept.left + kept.width > field.left + field.width ||
                    kept.top + kept.height > field.top + field.height)
                    continue;
                const Box box = box_of(kept);
                if (std::any_of(taken.begin(), taken.end(), [&](const Rect& other) {
                        return meet(grown(box_of(other), clear.words / 2), grown(box, clear.words / 2));
                    }))
                    continue;
                const auto within = [&](const std::vector<Point>& all) {
                    return kContourStep *
                           static_cast<double>(std::count_if(all.begin(), all.end(), [&](Point p) { return kept.holds(p); }));
                };
                const double lost = within(own);
                if (length - lost < kLeastLineLeft || lost >= fewest) continue;
                bool alone = true;
                for (std::size_t i = 0; i < places.size() && alone; ++i) alone = within(places[i]) <= (i == number ? lost : 0);
                if (!alone) continue;
                fewest = lost;
                level.label = words;
            }
        }
        if (level.label) taken.push_back(*level.label);
    }
}

}  // namespace

double share_near(const std::vector<ChartLevel>& levels) {
    Box box = kNothing;
    for (const ChartLevel& level : levels)
        for (const auto& line : level.lines)
            for (const Point& p : line) box.take(p);
    Places places(box, kHardToTell);
    std::vector<std::size_t> level_of;
    for (std::size_t i = 0; i < levels.size(); ++i)
        for (const auto& line : levels[i].lines)
            for (const Point& p : even_places(line)) {
                places.add(p);
                level_of.push_back(i);
            }
    double near = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        near += places.any_near(
                    places[i], kHardToTell,
                    [&](std::size_t k) { return level_of[k] != level_of[i] && distance(places[k], places[i]) < kHardToTell; })
                    ? 1
                    : 0;
    return places.size() > 0 ? near / static_cast<double>(places.size()) : 0;
}

Rect kept_by(const Rect& words, const Clearance& clear) {
    return {words.left - clear.set_across, words.top - clear.set_down, words.width + 2 * clear.set_across,
            words.height + 2 * clear.set_down};
}

std::vector<ChartLevel> levels_on(const PlotSurface& surface, const AxisScale& across, const AxisScale& up, int wanted,
                                  const LevelGround& ground) {
    std::vector<ChartLevel> best;
    std::ptrdiff_t fewest = 0;
    for (int most = wanted > 0 ? wanted : kMostContourLevels; most >= kFewestLevels; --most) {
        const std::vector<double> heights = contour_levels(surface, most);
        if (!best.empty() && heights.size() < static_cast<std::size_t>(kFewestLevels)) break;
        std::vector<ChartLevel> levels = lines_of(surface, across, up, heights, ground.height);
        label_levels(levels, ground);
        const auto silent = std::count_if(levels.begin(), levels.end(), [](const ChartLevel& level) { return !level.label; });
        const bool near = share_near(levels) > kMostNear;
        const std::ptrdiff_t faults = silent + (near ? kMostContourLevels : 0);
        if (best.empty() || faults < fewest) {
            best = std::move(levels);
            fewest = faults;
        }
        if (fewest == 0 || wanted > 0) break;
    }
    return best;
}

}  // namespace tactics
