// SPDX-License-Identifier: Apache-2.0
// Where the dots of a row of braille cells stand.
#include "tactics/page.h"

namespace tactics {

std::vector<Point> dots_of(const BrailleLine& line, const CellSize& cell) {
    // Dots 1-3 go down the left column, 4-6 down the right one; 7 and 8 lie below them.
    struct Seat {
        int column;
        int row;
    };
    constexpr Seat kSeats[] = {{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}, {0, 3}, {1, 3}};
    std::vector<Point> dots;
    for (std::size_t i = 0; i < line.cells.size(); ++i) {
        for (unsigned dot = 0; dot < 8; ++dot) {
            if ((line.cells[i] >> dot & 1u) == 0) continue;
            dots.push_back({line.first_dot.x + static_cast<double>(i) * cell.cell_pitch + kSeats[dot].column * cell.dot_pitch,
                            line.first_dot.y + kSeats[dot].row * cell.dot_pitch});
        }
    }
    return dots;
}

}  // namespace tactics
