#include "tactics/dot_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tactics/error.h"

namespace tactics {

DotGrid cell_grid(const Rect& live, const CellSize& cell) {
    if (!(cell.dot_pitch > 0) || !(cell.cell_pitch > cell.dot_pitch) || !(cell.line_pitch > 2 * cell.dot_pitch))
        throw std::logic_error("braille cells overlap");
    constexpr double kRounding = 1e-6;  // a live area of exactly 40 cells has 40
    const double cells = std::floor((live.width - cell.dot_pitch + kRounding) / cell.cell_pitch) + 1;
    const double lines = std::floor((live.height - 2 * cell.dot_pitch + kRounding) / cell.line_pitch) + 1;
    if (!(cells >= 1) || !(lines >= 1))
        throw Error(Fault::usage, "", "there is no room for a braille cell on the page; take larger paper or a smaller margin");
    // A sheet has at most 5 m on a side (find_paper), 2 million dots of this size.
    constexpr double kMostDots = 16e6;
    if (cells * lines * 6 > kMostDots) throw Error(Fault::usage, "", "the page has over 16 million dots; take smaller paper");
    // What is left over stands half on each side, so that no edge is further from a dot than the grid's own gaps.
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
