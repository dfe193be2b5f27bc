// SPDX-License-Identifier: Apache-2.0
// Braille read off a rendered page as a finger would: from dots alone, knowing nothing of where they were put.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "tactics/page.h"
#include "tests/print/rendered_page.h"

namespace tactics::rendered {

/// Middles, in mm, of the black spots that are as wide as a braille dot.
inline std::vector<Point> dots_on(const Pixels& page, double dpi, double diameter) {
    const double mm = 25.4 / dpi;
    std::vector<std::uint8_t> seen(page.black.size());
    std::vector<Point> dots;
    for (int y = 0; y < page.height; ++y)
        for (int x = 0; x < page.width; ++x) {
            const auto index = [&](int column, int row) {
                return static_cast<std::size_t>(row) * static_cast<std::size_t>(page.width) + static_cast<std::size_t>(column);
            };
            if (!page.at(x, y) || seen[index(x, y)] != 0) continue;
            std::vector<std::pair<int, int>> spot{{x, y}};
            seen[index(x, y)] = 1;
            int left = x, right = x, top = y, bottom = y;
            for (std::size_t i = 0; i < spot.size(); ++i) {
                const auto [px, py] = spot[i];
                left = std::min(left, px), right = std::max(right, px), top = std::min(top, py), bottom = std::max(bottom, py);
                for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
                    if (page.at(px + dx, py + dy) && seen[index(px + dx, py + dy)] == 0) {
                        seen[index(px + dx, py + dy)] = 1;
                        spot.push_back({px + dx, py + dy});
                    }
            }
            const double wide = (right - left + 1) * mm, high = (bottom - top + 1) * mm;
            if (std::abs(wide - diameter) < 0.3 && std::abs(high - diameter) < 0.3)
                dots.push_back({(left + right + 1) * mm / 2, (top + bottom + 1) * mm / 2});
        }
    return dots;
}

/// The lines of cells from top to bottom; six dots. A line's first dots tell where its cells begin, so a line must have a dot in
/// its first and its third row, and one in each column of a cell somewhere.
inline std::vector<std::vector<std::uint8_t>> cells_of(std::vector<Point> dots, const CellSize& size) {
    std::sort(dots.begin(), dots.end(), [](Point a, Point b) { return a.y < b.y; });
    std::vector<std::vector<std::uint8_t>> lines;
    for (std::size_t begin = 0; begin < dots.size();) {
        std::size_t end = begin;
        while (end < dots.size() && dots[end].y < dots[begin].y + 2.5 * size.dot_pitch) ++end;
        const std::vector<Point> line(dots.begin() + static_cast<std::ptrdiff_t>(begin),
                                      dots.begin() + static_cast<std::ptrdiff_t>(end));
        double top = line.front().y;
        // The phase of the cells: with it every dot is in a left or in a right column.
        double best = 1e9, phase = 0;
        for (const Point& dot : line)
            for (const double shift : {0.0, size.dot_pitch}) {
                double worst = 0;
                for (const Point& other : line) {
                    const double along = std::fmod(other.x - dot.x + shift + 1000 * size.cell_pitch, size.cell_pitch);
                    worst = std::max(worst, std::min({along, std::abs(along - size.dot_pitch), size.cell_pitch - along}));
                }
                if (worst < best) best = worst, phase = dot.x - shift;
            }
        std::map<int, std::uint8_t> cells;
        for (const Point& dot : line) {
            const double along = (dot.x - phase) / size.cell_pitch;
            const int cell = static_cast<int>(std::floor(along + 0.1));
            const int column = along - cell > 0.2 ? 1 : 0;
            const int row = static_cast<int>(std::lround((dot.y - top) / size.dot_pitch));
            cells[cell] = static_cast<std::uint8_t>(cells[cell] | 1u << (3 * column + row));
        }
        auto& read = lines.emplace_back();
        for (int cell = cells.begin()->first; cell <= cells.rbegin()->first; ++cell)
            read.push_back(cells.contains(cell) ? cells[cell] : std::uint8_t{0});
        begin = end;
    }
    return lines;
}

}  // namespace tactics::rendered
