// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/line_hatches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "tactics/readers/svg/svg_pattern.h"

namespace tactics {

namespace {

// mm of a figure that is 200 mm wide or high; settings.
constexpr double kOnSide = 0.3, kFarthestLines = 7, kLeastLine = 0.3, kUneven = 0.12;
constexpr std::size_t kFewestLines = 3;
constexpr std::size_t kMostPairsInside = 20'000'000;  // of lines and rectangles

struct HatchLine {
    std::size_t stroke = 0;
    int degrees = 0;   // from 0 to 179
    double aside = 0;  // from the page's corner, across its direction
};

bool is_on_side(const Box& box, Point p) {
    if (!grown(box, kOnSide).holds(p)) return false;
    return std::min({p.x - box.left, box.right - p.x, p.y - box.top, box.bottom - p.y}) < kOnSide;
}

// From side to side, and not along one.
bool runs_through(const Box& box, Point a, Point b) {
    const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    return is_on_side(box, a) && is_on_side(box, b) && grown(box, -kOnSide).holds(middle);
}

HatchLine hatch_line(std::size_t stroke, Point a, Point b) {
    const double angle = std::atan2(b.y - a.y, b.x - a.x);
    int degrees = static_cast<int>(std::lround(angle * 180 / std::numbers::pi));
    degrees = (degrees + 360) % 180;
    const double turned = degrees * std::numbers::pi / 180;
    return {stroke, degrees, b.y * std::cos(turned) - b.x * std::sin(turned)};
}

// The distance between lines side by side, if it is the same for all; 0 where it is not.
double even_distance(std::vector<double> places) {
    if (places.size() < kFewestLines) return 0;
    std::sort(places.begin(), places.end());
    const double mean = (places.back() - places.front()) / static_cast<double>(places.size() - 1);
    for (std::size_t i = 1; i < places.size(); ++i)
        if (std::abs(places[i] - places[i - 1] - mean) > std::max(kOnSide, kUneven * mean)) return 0;
    return mean < kFarthestLines ? mean : 0;
}

using Directions = std::map<int, std::vector<HatchLine>>;

Directions by_direction(const std::vector<HatchLine>& lines) {
    Directions directions;
    for (const HatchLine& line : lines) {
        auto at = directions.begin();
        while (at != directions.end() && std::abs(at->first - line.degrees) > 1) ++at;
        (at == directions.end() ? directions[line.degrees] : at->second).push_back(line);
    }
    return directions;
}

// What the hatch of such lines is, or nothing: its directions, each with its distance in halves of a millimetre.
std::map<int, long> kind_of(const Directions& directions) {
    std::map<int, long> kind;
    for (const auto& [degrees, lines] : directions) {
        std::vector<double> places;
        for (const HatchLine& line : lines) places.push_back(line.aside);
        const double apart = even_distance(places);
        if (apart <= 0) return {};
        kind[degrees] = std::lround(2 * apart);
    }
    return kind;
}

bool same_hatch(const std::map<int, long>& a, const std::map<int, long>& b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const auto& one, const auto& other) {
               return std::abs(one.first - other.first) <= 1 && std::abs(one.second - other.second) <= 1;
           });
}

// Too few lines to tell their distance: the only kind of that direction.
bool may_be(const Directions& directions, const std::map<int, long>& kind) {
    return !directions.empty() && directions.size() <= kind.size() &&
           std::all_of(directions.begin(), directions.end(), [&](const auto& one) {
               return std::any_of(kind.begin(), kind.end(),
                                  [&](const auto& other) { return std::abs(one.first - other.first) <= 1; });
           });
}

// The lines that run through each rectangle, but through no smaller one.
std::vector<std::vector<HatchLine>> lines_through(const FoundPage& figure, const std::vector<Box>& rectangles) {
    std::vector<std::vector<HatchLine>> through(rectangles.size());
    const auto& strokes = figure.page.strokes;
    if (strokes.size() * rectangles.size() > kMostPairsInside) return through;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const auto& points = strokes[i].points;
        if (strokes[i].closed || points.size() != 2 || distance(points[0], points[1]) < kLeastLine) continue;
        std::size_t best = rectangles.size();
        const auto size = [&](std::size_t r) { return rectangles[r].width() * rectangles[r].height(); };
        for (std::size_t r = 0; r < rectangles.size(); ++r)
            if (runs_through(rectangles[r], points[0], points[1]) && (best == rectangles.size() || size(r) < size(best)))
                best = r;
        if (best < rectangles.size()) through[best].push_back(hatch_line(i, points[0], points[1]));
    }
    return through;
}

}  // namespace

std::vector<LineHatch> line_hatches_in(const FoundPage& figure, const std::vector<Box>& rectangles) {
    std::vector<LineHatch> hatches(rectangles.size());
    struct Kind {
        std::map<int, long> lines;
        std::vector<std::size_t> rectangles;
    };
    std::vector<Kind> kinds;
    std::vector<std::pair<std::size_t, Directions>> few;
    const std::vector<std::vector<HatchLine>> through = lines_through(figure, rectangles);
    for (std::size_t r = 0; r < rectangles.size(); ++r) {
        for (const HatchLine& line : through[r]) hatches[r].strokes.push_back(line.stroke);
        Directions directions = by_direction(through[r]);
        const std::map<int, long> lines = kind_of(directions);
        if (lines.empty()) {
            few.emplace_back(r, std::move(directions));
            continue;
        }
        auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& one) { return same_hatch(one.lines, lines); });
        if (kind == kinds.end()) kind = kinds.insert(kind, Kind{lines, {}});
        kind->rectangles.push_back(r);
    }
    for (const auto& [r, directions] : few) {
        Kind* only = nullptr;
        std::size_t count = 0;
        for (Kind& kind : kinds)
            if (may_be(directions, kind.lines) && ++count > 0) only = &kind;
        if (count == 1) only->rectangles.push_back(r);
    }
    for (const Kind& kind : kinds) {
        if (kind.rectangles.size() < 2) continue;
        std::string words;
        for (const auto& [degrees, apart] : kind.lines) words += std::to_string(degrees) + ' ' + std::to_string(apart) + ' ';
        for (const std::size_t r : kind.rectangles) hatches[r].number = pattern_number(words);
    }
    for (LineHatch& hatch : hatches)
        if (hatch.number <= 0) hatch.strokes.clear();
    return hatches;
}

}  // namespace tactics
