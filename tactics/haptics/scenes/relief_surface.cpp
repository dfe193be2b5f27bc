// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/relief_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tactics {

namespace {

void must_be_whole(const HeightMap& map) {
    if (map.columns < 1 || map.rows < 1 ||
        map.heights.size() != static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows))
        throw std::logic_error("a height map has columns x rows heights, at least one");
    if (!std::isfinite(map.pitch) || map.pitch <= 0) throw std::logic_error("a height map has a pitch");
}

// From the rim of a hole inwards, ring by ring, each sample the mean of those around it that were known a ring before: the same
// from every side, and linear in the size of the map.
void fill_holes(HeightMap& map) {
    constexpr char kUnknown = 0, kKnown = 1, kNext = 2;
    std::vector<char> state(map.heights.size(), kKnown);
    std::vector<std::size_t> holes;
    for (std::size_t i = 0; i < map.heights.size(); ++i)
        if (!std::isfinite(map.heights[i])) {
            state[i] = kUnknown;
            holes.push_back(i);
        }
    if (holes.empty()) return;
    if (holes.size() == map.heights.size()) {
        std::fill(map.heights.begin(), map.heights.end(), 0.0F);
        return;
    }
    const auto for_neighbours = [&](std::size_t index, auto visit) {
        const int column = static_cast<int>(index % static_cast<std::size_t>(map.columns)),
                  row = static_cast<int>(index / static_cast<std::size_t>(map.columns));
        for (int y = std::max(row - 1, 0); y <= std::min(row + 1, map.rows - 1); ++y)
            for (int x = std::max(column - 1, 0); x <= std::min(column + 1, map.columns - 1); ++x)
                visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(map.columns) + static_cast<std::size_t>(x));
    };
    std::vector<std::size_t> ring, next;
    for (const std::size_t hole : holes) {
        bool rim = false;
        for_neighbours(hole, [&](std::size_t i) { rim = rim || state[i] == kKnown; });
        if (rim) ring.push_back(hole);
    }
    while (!ring.empty()) {
        next.clear();
        for (const std::size_t hole : ring) {
            double sum = 0;
            int known = 0;
            for_neighbours(hole, [&](std::size_t i) {
                if (state[i] == kKnown) {
                    sum += static_cast<double>(map.heights[i]);
                    ++known;
                }
            });
            map.heights[hole] = static_cast<float>(sum / known);
        }
        for (const std::size_t hole : ring) state[hole] = kKnown;
        for (const std::size_t hole : ring)
            for_neighbours(hole, [&](std::size_t i) {
                if (state[i] != kUnknown) return;
                state[i] = kNext;
                next.push_back(i);
            });
        ring.swap(next);
    }
}

}  // namespace

HeightMap dilated(const HeightMap& map, double radius) {
    must_be_whole(map);
    if (!(radius > 0)) return map;
    HeightMap filled = map;
    fill_holes(filled);
    HeightMap made = filled;
    const auto [lowest, highest] = std::minmax_element(filled.heights.begin(), filled.heights.end());
    // Where the ball is farther above its foot than the map is high, it cannot touch, so the search ends there.
    const double relief = static_cast<double>(*highest) - static_cast<double>(*lowest);
    const double farthest = relief < radius ? std::sqrt(relief * (2 * radius - relief)) : radius;
    const double reach = std::min(std::floor(farthest / map.pitch), static_cast<double>(std::max(map.columns, map.rows) - 1));
    const int most = static_cast<int>(reach);
    for (int y = 0; y < map.rows; ++y) {
        float* const row = &made.at(0, y);
        for (int dy = std::max(-most, -y); dy <= std::min(most, map.rows - 1 - y); ++dy) {
            const float* const other = &filled.at(0, y + dy);
            for (int dx = -most; dx <= most; ++dx) {
                const double left =
                    radius * radius - (static_cast<double>(dx) * dx + static_cast<double>(dy) * dy) * map.pitch * map.pitch;
                if (left < 0 || std::abs(dx) >= map.columns) continue;
                const auto sunk = static_cast<float>(std::sqrt(left) - radius);
                const int end = std::min(map.columns, map.columns - dx);
                for (int x = std::max(0, -dx); x < end; ++x) {
                    const float touched = other[x + dx] + sunk;
                    row[x] = touched > row[x] ? touched : row[x];
                }
            }
        }
    }
    return made;
}

ReliefSurface::ReliefSurface(HeightMap map) : map_(std::move(map)) {
    must_be_whole(map_);
    fill_holes(map_);
    per_mm_ = 1 / map_.pitch;
    last_column_ = map_.columns - 1;
    last_row_ = map_.rows - 1;
    right_ = map_.columns > 1 ? 1 : 0;
    below_ = map_.rows > 1 ? map_.columns : 0;
    last_square_column_ = std::max(map_.columns - 2, 0);
    last_square_row_ = std::max(map_.rows - 2, 0);
    const auto [lowest, highest] = std::minmax_element(map_.heights.begin(), map_.heights.end());
    lowest_ = static_cast<double>(*lowest);
    highest_ = static_cast<double>(*highest);
}

ReliefSurface::Square ReliefSurface::square_at(double u, double v) const noexcept {
    const double column = std::clamp(u, 0.0, last_column_), row = std::clamp(v, 0.0, last_row_);
    const int i = std::min(static_cast<int>(column), last_square_column_), j = std::min(static_cast<int>(row), last_square_row_);
    return {map_.heights.data() + static_cast<std::ptrdiff_t>(j) * map_.columns + i, column - i, row - j};
}

double ReliefSurface::height(Point at) const noexcept {
    if (std::isnan(at.x) || std::isnan(at.y)) return lowest_;
    const Square square = square_at(at.x * per_mm_ - 0.5, at.y * per_mm_ - 0.5);
    const double a = static_cast<double>(square.first[0]), b = static_cast<double>(square.first[right_]);
    const double c = static_cast<double>(square.first[below_]), d = static_cast<double>(square.first[below_ + right_]);
    const double above = a + (b - a) * square.across, beneath = c + (d - c) * square.across;
    return above + (beneath - above) * square.down;
}

Point ReliefSurface::slope(Point at) const noexcept {
    if (std::isnan(at.x) || std::isnan(at.y)) return {};
    const double u = at.x * per_mm_ - 0.5, v = at.y * per_mm_ - 0.5;
    const Square square = square_at(u, v);
    const double a = static_cast<double>(square.first[0]), b = static_cast<double>(square.first[right_]);
    const double c = static_cast<double>(square.first[below_]), d = static_cast<double>(square.first[below_ + right_]);
    const bool beside = u < 0 || u > last_column_, beyond = v < 0 || v > last_row_;
    return {beside ? 0 : ((b - a) + ((d - c) - (b - a)) * square.down) * per_mm_,
            beyond ? 0 : ((c - a) + ((d - b) - (c - a)) * square.across) * per_mm_};
}

}  // namespace tactics
