// From a page to raised dots, for everything that has dots instead of ink.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// Where dots can be raised: centres of the columns and rows in mm, ascending, at least 2 of each. They need not be even:
/// braille cells leave a wider gap between cells and between lines than between their own dots.
struct DotGrid {
    std::vector<double> columns;
    std::vector<double> rows;
};

/// The grid of as many whole 6-dot cells as `live` holds, in its middle; all centres lie within it. Two columns a cell,
/// three rows a line. Where live is whole cells, its left top corner is the centre of dot 1 of the first cell.
/// Throws Error(usage) if there is no room for one cell.
DotGrid cell_grid(const Rect& live, const CellSize& cell);

struct Dots {
    int columns = 0;
    int rows = 0;
    std::vector<std::uint8_t> raised;  ///< 0 or 1, row by row from the top

    std::uint8_t& at(int column, int row) { return raised[index(column, row)]; }
    std::uint8_t at(int column, int row) const { return raised[index(column, row)]; }

private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }
};

/// The drawing of a page (strokes, areas, picture; not its braille and print) as dots, each where it truly stands:
/// - a stroke is a chain of single dots (dot_chain.h), whatever its width;
/// - an area raises the dots inside (even-odd); one that is too narrow to hold a dot is drawn as its outline;
/// - a picture raises a dot where at least half of the paper around it is black, and along lines that are thinner.
/// What lies further than one pitch outside the grid is left out.
Dots raise_dots(const Page& page, const DotGrid& grid);

}  // namespace tactics
