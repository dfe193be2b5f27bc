#include "print/cell_rows.h"

#include <algorithm>
#include <cmath>

#include "print/dots.h"

namespace tactics {

namespace {

// Which bit a dot is, by its row and column in the cell.
constexpr std::uint8_t kBits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};

}  // namespace

CellRows cell_rows(const Page& page) {
    const DotGrid grid = dot_grid(page);
    const Dots dots = raise_dots(page, grid);
    const int down = page.bed ? page.bed->dots_down : 3;
    const CellSize& cell = page.cell;
    // Cells of the machine that lie in the margin.
    const auto before = [](double first, double bed, double pitch) { return static_cast<std::size_t>(std::lround((first - bed) / pitch)); };
    const std::size_t left = page.bed ? before(grid.columns[0], page.bed->first.x, cell.cell_pitch) : 0;
    const std::size_t above = page.bed ? before(grid.rows[0], page.bed->first.y, cell.line_pitch) : 0;
    CellRows rows;
    rows.columns = left + grid.columns.size() / 2;
    rows.lines = above + grid.rows.size() / static_cast<std::size_t>(down);
    rows.cells.resize(rows.columns * rows.lines);
    const auto at = [&](std::size_t column, std::size_t line) -> std::uint8_t& { return rows.cells[line * rows.columns + column]; };
    for (int row = 0; row < dots.rows; ++row)
        for (int column = 0; column < dots.columns; ++column)
            if (dots.at(column, row) != 0)
                at(left + static_cast<std::size_t>(column / 2), above + static_cast<std::size_t>(row / down)) |= kBits[row % down][column % 2];

    for (const BrailleLine& line : page.braille) {
        const double row = std::round((line.first_dot.y - grid.rows[0]) / cell.line_pitch) + static_cast<double>(above);
        if (!(row >= 0) || row >= static_cast<double>(rows.lines)) continue;
        const double first = std::round((line.first_dot.x - grid.columns[0]) / cell.cell_pitch) + static_cast<double>(left);
        for (std::size_t i = 0; i < line.cells.size(); ++i) {
            const double column = first + static_cast<double>(i);
            if (column >= 0 && column < static_cast<double>(rows.columns))
                at(static_cast<std::size_t>(column), static_cast<std::size_t>(row)) =
                    down == 4 ? line.cells[i] : static_cast<std::uint8_t>(line.cells[i] & 0x3Fu);
        }
    }
    return rows;
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
