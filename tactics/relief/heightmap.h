// SPDX-License-Identifier: Apache-2.0
// Heights on a regular grid: a relief, a terrain or the front of a model, as felt by a finger that moves over it.
#pragma once

#include <cstddef>
#include <vector>

namespace tactics {

struct HeightMap {
    int columns = 0;
    int rows = 0;
    double pitch = 0;  ///< mm from one sample to the next, in both directions
    std::vector<float>
        heights;  ///< mm, row by row from the top; each at the centre of its square, so the first is half a pitch from both edges

    float at(int column, int row) const { return heights[index(column, row)]; }
    float& at(int column, int row) { return heights[index(column, row)]; }
    double width() const { return columns * pitch; }  ///< mm
    double height() const { return rows * pitch; }    ///< mm, from its upper to its lower edge

private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }
};

}  // namespace tactics
