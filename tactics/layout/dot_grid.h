// SPDX-License-Identifier: Apache-2.0
// Where an embosser can raise dots: the cells of braille.
#pragma once

#include <vector>

#include "tactics/page.h"

namespace tactics {

/// The possible positions of dots: centres of the columns and rows in mm, ascending, at least 2 of each. Spacing may be uneven:
/// the gap between braille cells and between lines is wider than between dots of a cell.
struct DotGrid {
    std::vector<double> columns;
    std::vector<double> rows;
};

/// The possible dots within the live area of a page: those of its machine (in whole cells, or on the raster), or else
/// cell_grid(page.live, page.cell). Throws Error(usage) if there is no room for one cell.
DotGrid dot_grid(const Page& page);

/// Moves braille lines to the nearest place where the page's machine has dots for them; without a machine they stay.
void put_on_dots(Page& page);

/// The grid of as many whole 6-dot cells as `live` holds, in its middle; all centres lie within it. Each cell has two columns,
/// each line three rows. If `live` holds exactly whole cells, its top left corner is the centre of dot 1 of the first cell.
/// Throws Error(usage) if there is no room for one cell.
DotGrid cell_grid(const Rect& live, const CellSize& cell);

}  // namespace tactics
