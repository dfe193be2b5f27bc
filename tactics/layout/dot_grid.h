// SPDX-License-Identifier: Apache-2.0
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

/// The dots that can be raised within the live area of a page: of its machine (those of whole cells, or of the raster), or else
/// cell_grid(page.live, page.cell). Throws Error(usage) if there is no room for one cell.
DotGrid dot_grid(const Page& page);

/// Moves lines of braille to the nearest place where the page's machine has dots for them; without a machine they stay.
void put_on_dots(Page& page);

/// The grid of as many whole 6-dot cells as `live` holds, in its middle; all centres lie within it. Two columns a cell,
/// three rows a line. Where live is whole cells, its left top corner is the centre of dot 1 of the first cell.
/// Throws Error(usage) if there is no room for one cell.
DotGrid cell_grid(const Rect& live, const CellSize& cell);

}  // namespace tactics
