// Where an embosser can raise dots: the cells of braille.
#pragma once

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

}  // namespace tactics
