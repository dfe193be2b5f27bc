// SPDX-License-Identifier: Apache-2.0
// Boxes of a picture, found again by where they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tactics/lettering/ink.h"

namespace tactics {

class FoundBoxes {
public:
    /// For a picture of that size, in whose coordinates they are.
    FoundBoxes(int width, int height);

    void add(const PixelBox& box);

    /// Calls visit(number, box) for each box that has pixels of `box`, until it gives true; then gives true. Numbers are in the
    /// order in which boxes were added; one may come up several times.
    template <typename Visit>
    bool any_on(const PixelBox& box, Visit visit) const {
        const PixelBox cells = cells_of(box);
        for (int row = cells.top; row < cells.bottom; ++row)
            for (int column = cells.left; column < cells.right; ++column)
                for (const std::uint32_t number : cells_[index_of(column, row)])
                    if (overlap(boxes_[number], box) && visit(std::size_t{number}, boxes_[number])) return true;
        return false;
    }

private:
    PixelBox cells_of(const PixelBox& box) const;
    std::size_t index_of(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }

    int columns_, rows_;
    std::vector<PixelBox> boxes_;
    std::vector<std::vector<std::uint32_t>> cells_;  // numbers of the boxes in each
};

}  // namespace tactics
