// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tactics/geometry/box.h"
#include "tactics/geometry/course.h"
#include "tactics/geometry/triangulate.h"

namespace tactics {

namespace {

constexpr int kCells = 512;

// Which cells of a grid have something over their middle.
struct Shadow {
    int columns = 0, rows = 0;
    std::vector<char> dark;
    bool at(int column, int row) const {
        return column >= 0 && row >= 0 && column < columns && row < rows &&
               dark[static_cast<std::size_t>(row) * columns + column] != 0;
    }
};

// Rings in cells, by the even-odd rule along each row.
void fill(Shadow& shadow, const std::vector<std::vector<Point>>& rings) {
    std::vector<std::pair<int, double>> crossings;  // a row, and where along it
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            Point a = ring[i], b = ring[(i + 1) % ring.size()];
            if (a.y > b.y) std::swap(a, b);
            const int first = std::max(0, static_cast<int>(std::ceil(a.y - 0.5)));
            for (int row = first; row < shadow.rows && row + 0.5 < b.y; ++row)
                crossings.push_back({row, a.x + (row + 0.5 - a.y) / (b.y - a.y) * (b.x - a.x)});
        }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {  // a row has an even number of them
        const int from = std::max(0, static_cast<int>(std::ceil(crossings[i].second - 0.5)));
        const int to = std::min(shadow.columns, static_cast<int>(std::ceil(crossings[i + 1].second - 0.5)));
        const auto row = shadow.dark.begin() + static_cast<std::ptrdiff_t>(crossings[i].first) * shadow.columns;
        if (from < to) std::fill(row + from, row + to, char{1});
    }
}

// Borders of what is dark, which lies to the left; at a corner where two dark
// cells meet it turns left, and parts them.
std::vector<std::vector<Point>> borders_of(const Shadow& shadow) {
    constexpr int kX[] = {1, 0, -1, 0}, kY[] = {0, 1, 0, -1};
    // To the right along the lower sides of dark cells begins every ring.
    std::vector<char> gone(static_cast<std::size_t>(shadow.columns + 1) * (shadow.rows + 1), 0);
    const auto is_border = [&](int x, int y,
                               int way) {  // from the corner (x, y), with dark to
                                           // its left and light to its right
        switch (way) {
            case 0: return shadow.at(x, y) && !shadow.at(x, y - 1);
            case 1: return shadow.at(x - 1, y) && !shadow.at(x, y);
            case 2: return shadow.at(x - 1, y - 1) && !shadow.at(x - 1, y);
            default: return shadow.at(x, y - 1) && !shadow.at(x - 1, y - 1);
        }
    };
    std::vector<std::vector<Point>> rings;
    for (int row = 0; row < shadow.rows; ++row)
        for (int column = 0; column < shadow.columns; ++column) {
            if (!is_border(column, row, 0) || gone[static_cast<std::size_t>(row) * (shadow.columns + 1) + column] != 0) continue;
            std::vector<Point> ring;
            int x = column, y = row, way = 0;
            do {
                if (way == 0) gone[static_cast<std::size_t>(y) * (shadow.columns + 1) + x] = 1;
                ring.push_back({static_cast<double>(x), static_cast<double>(y)});
                x += kX[way];
                y += kY[way];
                for (const int turn : {1, 0, 3})
                    if (is_border(x, y, (way + turn) % 4)) {
                        way = (way + turn) % 4;
                        break;
                    }
            } while (x != column || y != row || way != 0);
            rings.push_back(std::move(ring));
        }
    return rings;
}

}  // namespace

OutlineOfPart outline_of(const Solid& solid, const Point3& normal, const Point3& u, const Point3& v) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    double left = kNone, right = -kNone, low = kNone, high = -kNone, top = -kNone;
    for (const Patch& patch : solid.patches)
        for (const auto& ring : patch.rings)
            for (const Point3& at : ring) {
                left = std::min(left, dot(at, u));
                right = std::max(right, dot(at, u));
                low = std::min(low, dot(at, v));
                high = std::max(high, dot(at, v));
                top = std::max(top, dot(at, normal));
            }
    OutlineOfPart outline;
    const double cell = std::max(right - left, high - low) / kCells;
    if (!(cell > 0)) return outline;
    Shadow shadow{std::max(1, static_cast<int>(std::ceil((right - left) / cell))),
                  std::max(1, static_cast<int>(std::ceil((high - low) / cell))),
                  {}};
    shadow.dark.assign(static_cast<std::size_t>(shadow.columns) * shadow.rows, 0);
    for (const Patch& patch : solid.patches) {
        std::vector<std::vector<Point>> rings;
        for (const auto& ring : patch.rings) {
            rings.emplace_back();
            for (const Point3& at : ring) rings.back().push_back({(dot(at, u) - left) / cell, (dot(at, v) - low) / cell});
        }
        fill(shadow, rings);
    }
    std::vector<std::vector<Point>> rings;
    Box box = kNothing;
    for (std::vector<Point> ring : borders_of(shadow)) {
        const double area = doubled_area(ring) / 2;
        if (std::abs(area) < 4) continue;
        ring.push_back(ring.front());
        ring = course_of(ring, 0.75);
        ring.pop_back();
        if (ring.size() < 3) continue;
        for (const Point& at : ring) box.take(at);
        rings.push_back(std::move(ring));
    }
    // As far as the solid reaches, which the grid knows to a cell only.
    const auto fitted = [](double at, double from, double to, double least, double most) {
        return least + (at - from) / (to - from) * (most - least);
    };
    for (const std::vector<Point>& ring : rings) {
        outline.rings.emplace_back();
        for (const Point& at : ring)
            outline.rings.back().push_back(fitted(at.x, box.left, box.right, left, right) * u +
                                           fitted(at.y, box.top, box.bottom, low, high) * v + top * normal);
        outline.area += doubled_area(ring) / 2 * (right - left) * (high - low) / (box.width() * box.height());
    }
    std::stable_sort(outline.rings.begin(), outline.rings.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return outline;
}

}  // namespace tactics
