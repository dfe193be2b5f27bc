// SPDX-License-Identifier: Apache-2.0
#include "tactics/rules/vicinity.h"

#include <algorithm>

namespace tactics {

namespace {

constexpr double kFinest = 2;        // mm
constexpr double kMostCells = 1000;  // each way

std::size_t cell_at(double place, double cell, std::size_t count) {
    const double number = place / cell;
    if (!(number > 0)) return 0;
    return number >= static_cast<double>(count) ? count - 1 : static_cast<std::size_t>(number);
}

}  // namespace

Vicinity::Vicinity(double width, double height)
    : cell_(std::max({kFinest, width / kMostCells, height / kMostCells})),
      columns_(1 + static_cast<std::size_t>(width / cell_)),
      rows_(1 + static_cast<std::size_t>(height / cell_)),
      cells_(columns_ * rows_) {}

void Vicinity::add(const Box& box) {
    for (std::size_t row = row_of(box.top); row <= row_of(box.bottom); ++row) {
        const auto begin = cells_.begin() + static_cast<std::ptrdiff_t>(row * columns_);
        std::fill(begin + static_cast<std::ptrdiff_t>(column_of(box.left)),
                  begin + static_cast<std::ptrdiff_t>(column_of(box.right) + 1), true);
    }
}

std::size_t Vicinity::column_of(double x) const { return cell_at(x, cell_, columns_); }
std::size_t Vicinity::row_of(double y) const { return cell_at(y, cell_, rows_); }

}  // namespace tactics
