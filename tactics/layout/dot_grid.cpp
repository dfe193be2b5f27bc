// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/dot_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tactics/error.h"

namespace tactics {

namespace {

constexpr double kGridRounding = 1e-6;  // a live area of exactly 40 cells has 40
constexpr SourceWords kNoRoom = "there is no room for a braille cell on the page; take larger paper or a smaller margin";
constexpr SourceWords kTooMany = "the page has over 16 million dots; take smaller paper";

// Centres of `dots` a cell, `step` from each other, of all cells `pitch` from each other that lie within [low, high], one
// of them at `first`.
std::vector<double> centres(double first, double pitch, int dots, double step, double low, double high) {
    std::vector<double> found;
    const double extent = (dots - 1) * step;
    for (double at = first + std::ceil((low - first) / pitch - kGridRounding) * pitch; at + extent <= high + kGridRounding;
         at += pitch)
        for (int dot = 0; dot < dots; ++dot) found.push_back(at + dot * step);
    return found;
}

// A sheet has at most 5 m on a side (find_paper), 2 million dots in cells.
constexpr double kMostDots = 16e6;

}  // namespace

DotGrid dot_grid(const Page& page) {
    if (!page.bed) return cell_grid(page.live, page.cell);
    const DotBed& bed = *page.bed;
    const CellSize& cell = page.cell;
    const Rect& live = page.live;
    const double right = live.left + live.width, bottom = live.top + live.height;
    if (bed.raster > 0 && !(live.width / bed.raster * (live.height / bed.raster) < kMostDots))
        throw Error(Fault::usage, "", phrase(kTooMany));
    const bool raster = bed.raster > 0;
    DotGrid grid{centres(bed.first.x, bed.across(cell), raster ? 1 : 2, cell.dot_pitch, live.left, right),
                 centres(bed.first.y, bed.down(cell), raster ? 1 : bed.dots_down, cell.dot_pitch, live.top, bottom)};
    if (grid.columns.size() < 2 || grid.rows.size() < 2) throw Error(Fault::usage, "", phrase(kNoRoom));
    return grid;
}

void put_on_dots(Page& page) {
    if (!page.bed) return;
    const Point first = page.bed->first;
    const double across = page.bed->across(page.cell), down = page.bed->down(page.cell);
    for (BrailleLine& line : page.braille)
        line.first_dot = {first.x + std::round((line.first_dot.x - first.x) / across) * across,
                          first.y + std::round((line.first_dot.y - first.y) / down) * down};
}

DotGrid cell_grid(const Rect& live, const CellSize& cell) {
    if (!(cell.dot_pitch > 0) || !(cell.cell_pitch > cell.dot_pitch) || !(cell.line_pitch > 2 * cell.dot_pitch))
        throw std::logic_error("braille cells overlap");
    const double cells = std::floor((live.width - cell.dot_pitch + kGridRounding) / cell.cell_pitch) + 1;
    const double lines = std::floor((live.height - 2 * cell.dot_pitch + kGridRounding) / cell.line_pitch) + 1;
    if (!(cells >= 1) || !(lines >= 1)) throw Error(Fault::usage, "", phrase(kNoRoom));
    if (cells * lines * 6 > kMostDots) throw Error(Fault::usage, "", phrase(kTooMany));
    // The remaining space is divided equally between both sides, so that no edge is farther from a dot than the grid's own gaps.
    const double left = live.left + std::max(0.0, live.width - (cells - 1) * cell.cell_pitch - cell.dot_pitch) / 2;
    const double top = live.top + std::max(0.0, live.height - (lines - 1) * cell.line_pitch - 2 * cell.dot_pitch) / 2;
    DotGrid grid;
    for (int i = 0; i < static_cast<int>(cells); ++i)
        for (int dot = 0; dot < 2; ++dot) grid.columns.push_back(left + i * cell.cell_pitch + dot * cell.dot_pitch);
    for (int i = 0; i < static_cast<int>(lines); ++i)
        for (int dot = 0; dot < 3; ++dot) grid.rows.push_back(top + i * cell.line_pitch + dot * cell.dot_pitch);
    return grid;
}

}  // namespace tactics
