// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "tactics/geometry/course.h"
#include "tactics/layout/chart_told.h"
#include "tactics/readers/svg/chart_bars.h"
#include "tactics/readers/svg/felt_heads.h"
#include "tactics/readers/svg/noisy_lines.h"

namespace tactics {

namespace {

constexpr double kTolerance =
    0.1;  // mm; half of what a fingertip feels of a step aside in a line, and less than a printer's dots
// A line's class against the widest that is common. A setting.
// Plotting tools draw data about twice as wide as axes, and no finger is to take the few error bars for beams.
constexpr double kThin = 0.7, kThick = 2.1;

// The widest of which there is at least a tenth of all line.
double common_width(const FoundPage& figure) {
    std::map<long, double> lengths;  // by hundredths of a millimetre
    double all = 0;
    for (const PageStroke& stroke : figure.page.strokes) {
        const double length = length_of(Stroke{stroke.points, stroke.closed});
        lengths[std::lround(stroke.width * 100)] += length;
        all += length;
    }
    for (auto width = lengths.rbegin(); width != lengths.rend(); ++width)
        if (width->second >= all / 10) return static_cast<double>(width->first) / 100;
    return 0;
}

// Rounded, so that the last digits of a file's units decide nothing: the same drawing in other units is the same page.
Point scaled(Point p, double scale) {
    constexpr double kSteps = 1e5;  // per mm
    return {std::round(p.x * scale * kSteps) / kSteps, std::round(p.y * scale * kSteps) / kSteps};
}

std::vector<Point> scaled(const std::vector<Point>& points, double scale) {
    std::vector<Point> out;
    for (const Point& p : points) {
        const Point q = scaled(p, scale);
        if (out.empty() || distance(out.back(), q) > 1e-6) out.push_back(q);
    }
    return out;
}

// Lines that were drawn already, found again by where they begin, go through and end.
class Drawn {
public:
    // A surface with a line around it, a frame drawn twice: the same line felt once.
    bool has(const std::vector<Stroke>& strokes, const Stroke& line) const {
        const auto like = [&](const Stroke& other) {
            return other.points.size() == line.points.size() && other.closed == line.closed &&
                   std::equal(line.points.begin(), line.points.end(), other.points.begin(),
                              [](Point a, Point b) { return distance(a, b) < kSame; });
        };
        Key low = places_of(line), high = low;
        for (double& place : low) place = std::floor((place - kSame) / kCell);
        for (double& place : high) place = std::floor((place + kSame) / kCell);
        // Each place lies in one cell or, near its edge, may be the same as one in the next.
        for (unsigned choice = 0; choice < 1u << low.size(); ++choice) {
            Key key = low;
            bool fresh = true;
            for (std::size_t i = 0; i < key.size(); ++i) {
                if ((choice >> i & 1) == 0) continue;
                key[i] = high[i];
                fresh = fresh && high[i] != low[i];
            }
            if (!fresh) continue;
            const auto cell = cells_.find(key);
            if (cell == cells_.end()) continue;
            if (std::any_of(cell->second.begin(), cell->second.end(), [&](std::size_t other) { return like(strokes[other]); }))
                return true;
        }
        return false;
    }

    void add(const Stroke& line, std::size_t number) {
        Key key = places_of(line);
        for (double& place : key) place = std::floor(place / kCell);
        auto& cell = cells_[key];
        if (cell.size() < kMostAlike) cell.push_back(number);
    }

private:
    using Key = std::array<double, 6>;
    static constexpr double kSame = 0.01, kCell = 0.25;  // mm
    // Lines that begin, go through and end at the same places and are not the same; more are not looked at.
    static constexpr std::size_t kMostAlike = 100;

    static Key places_of(const Stroke& line) {
        const Point &a = line.points.front(), &b = line.points[line.points.size() / 2], &c = line.points.back();
        return {a.x, a.y, b.x, b.y, c.x, c.y};
    }

    std::map<Key, std::vector<std::size_t>> cells_;
};

}  // namespace

ChartBars scaled(ChartBars bars, double scale) {
    for (ChartBar& bar : bars.bars)
        bar.box = {bar.box.left * scale, bar.box.top * scale, bar.box.right * scale, bar.box.bottom * scale};
    bars.base *= scale;
    return bars;
}

Drawing drawing_of_figure(const FoundPage& figure, double width) {
    const double scale = width / figure.page.width, common = common_width(figure);
    Drawing drawing;
    drawing.width = width;
    drawing.height = figure.page.height * scale;
    FeltBars bars = figure.bars ? felt_bars(scaled(*figure.bars, scale)) : FeltBars{};
    const auto is_of_bar = [&](const std::vector<Point>& line) {  // which is felt in another way
        return !bars.strokes.empty() && outlines_bar(*figure.bars, line);
    };
    std::size_t noisy_lines = 0;
    Drawn drawn;
    for (const PageStroke& stroke : figure.page.strokes) {
        if (is_of_bar(stroke.points)) continue;
        Stroke line;
        std::vector<Point> points = scaled(stroke.points, scale);
        const bool dashed = stroke.role == Role::dash || stroke.role == Role::dots, may = dashed || stroke.role == Role::line;
        if (const auto noisy = stroke.closed || !may ? std::nullopt : noisy_line(points)) {
            points = noisy->course;
            if (!dashed)
                for (const auto& [foot, tip] : noisy->spikes) drawing.strokes.push_back({{foot, tip}, false});
            ++noisy_lines;
        }
        line.closed = stroke.closed;
        if (line.closed && points.size() > 1) points.push_back(points.front());
        line.points = course_of(points, kTolerance);
        if (line.closed && line.points.size() > 1) line.points.pop_back();
        if (line.points.size() < 3) line.closed = false;
        if (line.points.size() < 2) continue;
        line.line = stroke.heavy                     ? LineClass::thick
                    : stroke.width < kThin * common  ? LineClass::thin
                    : stroke.width > kThick * common ? LineClass::thick
                                                     : LineClass::normal;
        line.role = stroke.role;
        if (drawn.has(drawing.strokes, line)) continue;
        drawn.add(line, drawing.strokes.size());
        drawing.strokes.push_back(std::move(line));
    }
    for (const auto* areas : {&figure.page.areas, &figure.page.textured})
        for (const Area& area : *areas) {
            Area moved = area;
            moved.rings.clear();
            for (const auto& ring : area.rings)
                if (auto points = scaled(ring, scale); points.size() > 2 && !is_of_bar(ring))
                    moved.rings.push_back(std::move(points));
            if (!moved.rings.empty()) drawing.areas.push_back(std::move(moved));
        }
    std::move(bars.strokes.begin(), bars.strokes.end(), std::back_inserter(drawing.strokes));
    std::move(bars.areas.begin(), bars.areas.end(), std::back_inserter(drawing.areas));
    if (noisy_lines > 0) drawing.remarks.push_back(told_of_noise(noisy_lines));
    make_heads_felt(drawing);
    drawing.regions = figure.page.regions;
    for (Region& region : drawing.regions) {
        region.at = {region.at.x * scale, region.at.y * scale};
        for (auto& ring : region.rings)
            for (Point& at : ring) at = {at.x * scale, at.y * scale};
    }
    return drawing;
}

}  // namespace tactics
