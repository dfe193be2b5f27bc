// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/growing_grid.h"

#include <cmath>

namespace tactics {

namespace {

constexpr std::size_t kBroad = 256;  // cells of one box; looking at some more boxes costs less than more cells do

}  // namespace

GrowingGrid::GrowingGrid(const Box& area, std::size_t expected) {
    const double width = area.width(), height = area.height();
    const double cells = static_cast<double>(std::max<std::size_t>(expected, 1));
    // Square ones, one a box; of a long and narrow area, a row of them.
    const double cell = std::max({std::sqrt(width * height / cells), width / cells, height / cells});
    if (cell > 0 && std::isfinite(cell)) {
        left_ = area.left;
        top_ = area.top;
        cell_ = cell;
        columns_ = 1 + static_cast<std::size_t>(width / cell);
        rows_ = 1 + static_cast<std::size_t>(height / cell);
    }
    newest_.assign(columns_ * rows_, kNone);
}

void GrowingGrid::add(const Box& box) {
    const auto number = static_cast<std::uint32_t>(boxes_.size());
    boxes_.push_back(box);
    spans_.push_back(span_of(box));
    const Span& span = spans_.back();
    if (span.right < span.left || span.bottom < span.top) return;  // round nothing
    if ((span.right - span.left + 1) * (span.bottom - span.top + 1) > kBroad) {
        broad_.push_back(number);
        return;
    }
    for (std::size_t row = span.top; row <= span.bottom; ++row)
        for (std::size_t column = span.left; column <= span.right; ++column) {
            std::uint32_t& newest = newest_[row * columns_ + column];
            entries_.push_back({number, newest});
            newest = static_cast<std::uint32_t>(entries_.size() - 1);
        }
}

}  // namespace tactics
