// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/found_boxes.h"

#include <algorithm>

namespace tactics {

namespace {

constexpr int kCell = 64;  // pixels; about the height of large print

int cells_in(int pixels) { return std::max(1, (pixels + kCell - 1) / kCell); }

}  // namespace

FoundBoxes::FoundBoxes(int width, int height) : columns_(cells_in(width)), rows_(cells_in(height)), cells_(index_of(0, rows_)) {}

PixelBox FoundBoxes::cells_of(const PixelBox& box) const {
    return {std::clamp(box.left / kCell, 0, columns_), std::clamp(box.top / kCell, 0, rows_),
            std::clamp(cells_in(box.right), 0, columns_), std::clamp(cells_in(box.bottom), 0, rows_)};
}

void FoundBoxes::add(const PixelBox& box) {
    const auto number = static_cast<std::uint32_t>(boxes_.size());
    boxes_.push_back(box);
    const PixelBox cells = cells_of(box);
    for (int row = cells.top; row < cells.bottom; ++row)
        for (int column = cells.left; column < cells.right; ++column) cells_[index_of(column, row)].push_back(number);
}

}  // namespace tactics
