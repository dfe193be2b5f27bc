// SPDX-License-Identifier: Apache-2.0
// From a page to lines of braille cells, for machines and files that take text.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// Cells from the first that the machine has on its sheet (page.bed) or from the first of the live area; bit 0 = dot 1 ...
/// bit 7 = dot 8.
struct CellRows {
    std::size_t columns = 0;
    std::size_t lines = 0;
    std::vector<std::uint8_t> cells;  ///< line by line

    std::span<const std::uint8_t> line(std::size_t number) const { return std::span(cells).subspan(number * columns, columns); }
};

/// The drawing raised dot by dot (dots.h), and the page's braille as whole cells in its place: a cell of both would say
/// something else. Where the machine's dots are equally far apart, a cell is two by four of them. Throws Error(usage) if there is
/// no room for one cell.
CellRows cell_rows(const Page& page);

/// So many cells of so many lines, whatever the page has: for a display of that size.
std::vector<std::uint8_t> cells_of(const Page& page, std::size_t columns, std::size_t lines);

/// Of a line, what is left without empty cells at its end.
std::span<const std::uint8_t> without_end(std::span<const std::uint8_t> line);
/// How many lines are left without empty ones at the end of the page.
std::size_t lines_used(const CellRows& rows);

}  // namespace tactics
