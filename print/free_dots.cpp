// SPDX-License-Identifier: Apache-2.0
#include "print/free_dots.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "print/dot_chain.h"
#include "tactics/geometry/places.h"
#include "tactics/geometry/shape.h"
#include "tactics/geometry/walk.h"

namespace tactics {

namespace {

// The dots of a page so far.
class Placed {
public:
    explicit Placed(const Page& page) : places_({0, 0, page.width, page.height}, kLeastBetweenDots) {}

    bool is_free(Point p) const {
        return !places_.any_near(p, kLeastBetweenDots,
                                 [&](std::size_t i) { return distance(p, places_[i]) < kLeastBetweenDots - 1e-9; });
    }
    void put(Point p) { places_.add(p); }
    void put_if_free(Point p) {
        if (is_free(p)) put(p);
    }
    std::vector<Point> all() const {
        std::vector<Point> all;
        for (std::size_t i = 0; i < places_.size(); ++i) all.push_back(places_[i]);
        return all;
    }

private:
    Places places_;
};

bool turns_sharply(Point before, Point at, Point after) {
    static const double kCosine = std::cos(kSharpTurn * std::numbers::pi / 180);
    const double ax = at.x - before.x, ay = at.y - before.y, bx = after.x - at.x, by = after.y - at.y;
    return ax * bx + ay * by < kCosine * std::sqrt(ax * ax + ay * ay) * std::sqrt(bx * bx + by * by);
}

// Along the line: where it was, `along` mm from its beginning.
void put_evenly(const std::vector<Point>& points, double spacing, bool closed, Placed& placed) {
    const double length = length_of(points, false);
    const auto steps = static_cast<std::size_t>(std::max(closed ? 3.0 : 1.0, std::round(length / spacing)));
    const double step = length / static_cast<double>(steps);
    const std::size_t count = closed ? steps : steps + 1;  // the last of a closed line is its first
    Walk walk(points, false);
    for (std::size_t i = 0; i < count; ++i) placed.put_if_free(walk.to(static_cast<double>(i) * step));
}

void put_line(const std::vector<Point>& line, bool closed, double spacing, Placed& placed) {
    std::vector<Point> points;
    for (const Point p : line)
        if (points.empty() || distance(points.back(), p) > 1e-6) points.push_back(p);
    if (closed && points.size() > 1 && distance(points.back(), points.front()) <= 1e-6) points.pop_back();
    if (points.size() < 2 || length_of(points, closed) < kLeastBetweenDots) {
        if (!points.empty()) placed.put_if_free(points[points.size() / 2]);
        return;
    }
    const std::size_t n = points.size();
    std::vector<std::size_t> turns;
    for (std::size_t i = 0; i < n; ++i)
        if ((closed || (i > 0 && i + 1 < n)) && turns_sharply(points[(i + n - 1) % n], points[i], points[(i + 1) % n]))
            turns.push_back(i);
    if (closed && turns.empty()) {
        points.push_back(points[0]);
        put_evenly(points, spacing, true, placed);
        return;
    }
    // Turns and ends come first, so that none gives way to a dot beside it.
    for (const std::size_t turn : turns) placed.put_if_free(points[turn]);
    if (closed) {
        std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(turns[0]), points.end());
        points.push_back(points[0]);
        for (std::size_t i = turns.size(); i-- > 0;) turns[i] -= turns[0];
        turns.erase(turns.begin());
    }
    turns.push_back(points.size() - 1);
    std::size_t first = 0;
    for (const std::size_t turn : turns) {
        const std::vector<Point> part(points.begin() + static_cast<std::ptrdiff_t>(first),
                                      points.begin() + static_cast<std::ptrdiff_t>(turn) + 1);
        put_evenly(part, spacing, false, placed);
        first = turn;
    }
}

// A raster over that place; the same all over the page, so that areas beside each other are in line.
DotGrid raster_over(double width, double height, double spacing) {
    DotGrid grid;
    for (double x = spacing / 2; x < width; x += spacing) grid.columns.push_back(x);
    for (double y = spacing / 2; y < height; y += spacing) grid.rows.push_back(y);
    return grid;
}

}  // namespace

std::vector<Point> free_dots(const Page& page, double spacing) {
    Placed placed(page);
    for (const BrailleLine& line : page.braille)
        for (const Point dot : dots_of(line, page.cell)) placed.put(dot);
    for (const Area& area : page.areas)
        for (const auto& ring : area.rings) put_line(ring, true, spacing, placed);
    // Lines before patterns, which give way.
    for (const bool pattern : {false, true})
        for (const PageStroke& stroke : page.strokes)
            if ((stroke.role == Role::pattern) == pattern) put_line(stroke.points, stroke.closed, spacing, placed);
    if (page.picture || !page.areas.empty()) {
        Page inside;
        inside.areas = page.areas;
        inside.picture = page.picture;
        const DotGrid grid = raster_over(page.width, page.height, spacing);
        if (grid.columns.size() > 1 && grid.rows.size() > 1) {
            const Dots dots = raise_dots(inside, grid);
            for (int row = 0; row < dots.rows; ++row)
                for (int column = 0; column < dots.columns; ++column)
                    if (dots.at(column, row) != 0)
                        placed.put_if_free(
                            {grid.columns[static_cast<std::size_t>(column)], grid.rows[static_cast<std::size_t>(row)]});
        }
    }
    std::vector<Point> dots = placed.all();
    std::sort(dots.begin(), dots.end(), [](Point a, Point b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
    return dots;
}

}  // namespace tactics
