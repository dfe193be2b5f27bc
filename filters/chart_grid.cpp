// SPDX-License-Identifier: Apache-2.0
#include "filters/chart_grid.h"

#include <algorithm>
#include <cmath>

#include "tactics/geometry/box.h"
#include "tactics/geometry/places.h"

namespace tactics {

namespace {

constexpr double kMark = 2.5, kDotMark = 0.02;  // mm
constexpr double kGridStep = 0.5;               // mm from one place that is kept clear of to the next
constexpr double kPitchInCells = 10;            // mm: a dot in every line of cells

class Ground {
public:
    Ground(const Drawing& drawing, const std::vector<Rect>& words, const Medium& medium)
        : words_(words),
          least_(least_apart(medium, medium.thin_line, medium.thick_line) + kGridStep),
          places_({0, 0, drawing.width, drawing.height}, least_) {
        for (const Stroke& stroke : drawing.strokes) add(stroke.points, stroke.closed);
        for (const Area& area : drawing.areas)
            for (const auto& ring : area.rings) add(ring, true);
    }

    void add(const std::vector<Point>& line, bool closed) {
        for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
            const Point a = line[i], b = line[(i + 1) % line.size()];
            const int steps = static_cast<int>(distance(a, b) / kGridStep) + 1;
            for (int k = 0; k <= steps; ++k) places_.add({a.x + (b.x - a.x) * k / steps, a.y + (b.y - a.y) * k / steps});
        }
    }

    bool is_free(Point at) const {
        if (std::any_of(words_.begin(), words_.end(), [&](const Rect& box) { return box.holds(at); })) return false;
        return !places_.any_near(at, least_, [&](std::size_t i) { return distance(places_[i], at) < least_; });
    }

private:
    const std::vector<Rect>& words_;
    double least_;
    Places places_;
};

}  // namespace

void draw_grid(Drawing& drawing, const std::vector<std::pair<Point, Point>>& lines, const std::vector<Rect>& words,
               const Medium& medium) {
    Ground ground(drawing, words, medium);
    const bool cells = has_fixed_dots(medium);
    const double mark = cells ? kDotMark : kMark, pitch = cells ? kPitchInCells : 2 * (medium.gap + medium.thin_line + kMark / 2);
    const auto line = [&](Point from, Point to) {
        const double length = distance(from, to);
        const auto at = [&](double along) {
            const double t = along / length;
            return Point{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
        };
        std::vector<std::vector<Point>> marks;
        for (double along = 0; along + mark <= length; along += pitch)
            if (ground.is_free(at(along)) && ground.is_free(at(along + mark / 2)) && ground.is_free(at(along + mark)))
                marks.push_back({at(along), at(along + mark)});
        for (auto& points : marks) {
            ground.add(points, false);
            drawing.strokes.push_back({std::move(points), false, LineClass::thin, 0, Role::grid});
        }
    };
    for (const auto& [from, to] : lines) line(from, to);
}

}  // namespace tactics
