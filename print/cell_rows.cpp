// SPDX-License-Identifier: Apache-2.0
#include "print/cell_rows.h"

#include <algorithm>
#include <cmath>

#include "print/dots.h"

namespace tactics {

namespace {

// Which bit a dot is, by its row and column in the cell.
constexpr std::uint8_t kBits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};

CellRows rows_of_raster(const Page& page) {
    const Dots dots = raise_on_bed(page);
    CellRows rows;
    rows.columns = (static_cast<std::size_t>(dots.columns) + 1) / 2;
    rows.lines = (static_cast<std::size_t>(dots.rows) + 3) / 4;
    rows.cells.resize(rows.columns * rows.lines);
    for (int row = 0; row < dots.rows; ++row)
        for (int column = 0; column < dots.columns; ++column)
            if (dots.at(column, row) != 0)
                rows.cells[static_cast<std::size_t>(row / 4) * rows.columns + static_cast<std::size_t>(column / 2)] |=
                    kBits[row % 4][column % 2];
    return rows;
}

}  // namespace

CellRows cell_rows(const Page& page) {
    if (page.bed && page.bed->raster > 0) return rows_of_raster(page);
    const DotGrid grid = dot_grid(page);
    const Dots dots = raise_dots(page, grid);
    const int down = page.bed ? page.bed->dots_down : 3;
    const CellSize& cell = page.cell;
    // Cells of the machine that lie in the margin; fewer than none: the page begins before them.
    const auto before = [](double first, double bed, double pitch) { return std::lround((first - bed) / pitch); };
    const long left = page.bed ? before(grid.columns[0], page.bed->first.x, cell.cell_pitch) : 0;
    const long above = page.bed ? before(grid.rows[0], page.bed->first.y, cell.line_pitch) : 0;
    CellRows rows;
    rows.columns = static_cast<std::size_t>(std::max(0L, left + dots.columns / 2));
    rows.lines = static_cast<std::size_t>(std::max(0L, above + dots.rows / down));
    rows.cells.resize(rows.columns * rows.lines);
    const auto find = [&](long column, long line) -> std::uint8_t* {
        if (column < 0 || line < 0 || column >= static_cast<long>(rows.columns) || line >= static_cast<long>(rows.lines))
            return nullptr;
        return &rows.cells[static_cast<std::size_t>(line) * rows.columns + static_cast<std::size_t>(column)];
    };
    for (int row = 0; row < dots.rows; ++row)
        for (int column = 0; column < dots.columns; ++column)
            if (dots.at(column, row) != 0)
                if (std::uint8_t* at = find(left + column / 2, above + row / down)) *at |= kBits[row % down][column % 2];

    for (const BrailleLine& line : page.braille) {
        const double row = std::round((line.first_dot.y - grid.rows[0]) / cell.line_pitch) + static_cast<double>(above);
        const double first = std::round((line.first_dot.x - grid.columns[0]) / cell.cell_pitch) + static_cast<double>(left);
        if (!(std::abs(row) < 1e6) || !(std::abs(first) < 1e6)) continue;
        for (std::size_t i = 0; i < line.cells.size(); ++i)
            if (std::uint8_t* at = find(static_cast<long>(first) + static_cast<long>(i), static_cast<long>(row)))
                *at = down == 4 ? line.cells[i] : static_cast<std::uint8_t>(line.cells[i] & 0x3Fu);
    }
    return rows;
}

std::vector<std::uint8_t> cells_of(const Page& page, std::size_t columns, std::size_t lines) {
    const CellRows rows = cell_rows(page);
    std::vector<std::uint8_t> cells(columns * lines);
    for (std::size_t line = 0; line < std::min(lines, rows.lines); ++line)
        std::copy_n(rows.line(line).begin(), std::min(columns, rows.columns),
                    cells.begin() + static_cast<std::ptrdiff_t>(line * columns));
    return cells;
}

std::span<const std::uint8_t> without_end(std::span<const std::uint8_t> line) {
    std::size_t end = line.size();
    while (end > 0 && line[end - 1] == 0) --end;
    return line.first(end);
}

std::size_t lines_used(const CellRows& rows) {
    std::size_t end = rows.lines;
    while (end > 0 && without_end(rows.line(end - 1)).empty()) --end;
    return end;
}

}  // namespace tactics
