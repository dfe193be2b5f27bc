// SPDX-License-Identifier: Apache-2.0
// From a page to lines of braille cells, for machines and formats that take text.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// Cells, starting at the machine's first cell on its sheet (page.bed) or at the first of the live area; bit 0 = dot 1 ... bit 7
/// = dot 8.
struct CellRows {
    std::size_t columns = 0;
    std::size_t lines = 0;
    std::vector<std::uint8_t> cells;  ///< line by line

    std::span<const std::uint8_t> line(std::size_t number) const { return std::span(cells).subspan(number * columns, columns); }
};

/// The drawing raised dot by dot (dots.h), with the page's braille as whole cells in its place, since a mixed cell would mean
/// something else. If the machine's dots are equally spaced, a cell is two by four of them. Throws Error(usage) if there is no
/// room for one cell.
CellRows cell_rows(const Page& page);

/// Exactly that many cells and lines, regardless of the page: for a display of that size.
std::vector<std::uint8_t> cells_of(const Page& page, std::size_t columns, std::size_t lines);

/// A line without the empty cells at its end.
std::span<const std::uint8_t> without_end(std::span<const std::uint8_t> line);
/// The number of lines without the empty ones at the end of the page.
std::size_t lines_used(const CellRows& rows);

}  // namespace tactics
