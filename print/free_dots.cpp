// SPDX-License-Identifier: Apache-2.0
#include "print/free_dots.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>

#include "print/dot_chain.h"
#include "tactics/geometry/shape.h"

namespace tactics {

namespace {

// Dots by squares as wide as they must stand apart: a dot has neighbours in the nine around it only.
class Placed {
public:
    bool is_free(Point p) const {
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (const auto found = squares_.find(key(p, dx, dy)); found != squares_.end())
                    for (const Point other : found->second)
                        if (distance(p, other) < kLeastBetweenDots - 1e-9) return false;
        return true;
    }
    void put(Point p) {
        squares_[key(p, 0, 0)].push_back(p);
        all_.push_back(p);
    }
    void put_if_free(Point p) {
        if (is_free(p)) put(p);
    }
    std::vector<Point> take() { return std::move(all_); }

private:
    static std::uint64_t key(Point p, int dx, int dy) {
        const auto square = [](double at, int step) {
            return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(at / kLeastBetweenDots)) + step);
        };
        return static_cast<std::uint64_t>(square(p.y, dy)) << 32 | square(p.x, dx);
    }
    std::unordered_map<std::uint64_t, std::vector<Point>> squares_;
    std::vector<Point> all_;
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
    std::size_t side = 1;
    double before = 0;  // length of the sides before this one
    for (std::size_t i = 0; i < count; ++i) {
        const double along = static_cast<double>(i) * step;
        double long_side = distance(points[side - 1], points[side]);
        while (side + 1 < points.size() && before + long_side < along) {
            before += long_side;
            ++side;
            long_side = distance(points[side - 1], points[side]);
        }
        const double t = long_side > 0 ? std::clamp((along - before) / long_side, 0.0, 1.0) : 0;
        const Point a = points[side - 1], b = points[side];
        placed.put_if_free({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
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
    Placed placed;
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
    std::vector<Point> dots = placed.take();
    std::sort(dots.begin(), dots.end(), [](Point a, Point b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
    return dots;
}

}  // namespace tactics
