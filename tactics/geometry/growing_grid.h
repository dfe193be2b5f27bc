// SPDX-License-Identifier: Apache-2.0
// Boxes added one by one and found by position. For boxes known from the beginning use a Grid, for points Places.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tactics/geometry/box.h"

namespace tactics {

class GrowingGrid {
public:
    /// For about `expected` boxes in `area`; for boxes outside, searches also visit distant ones. Has at most four times as many
    /// cells.
    GrowingGrid(const Box& area, std::size_t expected);

    void add(const Box& box);  ///< its number is the previous count
    std::size_t size() const { return boxes_.size(); }

    /// Calls visit(number) once for each box that meets `box`, in unspecified order, until it returns true; then returns true.
    template <typename Visit>
    bool any_near(const Box& box, Visit visit) const {
        for (const std::uint32_t number : broad_)
            if (meet(boxes_[number], box) && visit(std::size_t{number})) return true;
        const Span span = span_of(box);
        for (std::size_t row = span.top; row <= span.bottom; ++row)
            for (std::size_t column = span.left; column <= span.right; ++column)
                for (std::uint32_t i = newest_[row * columns_ + column]; i != kNone; i = entries_[i].next) {
                    const std::uint32_t number = entries_[i].number;
                    // In one cell of all that both are in: where both have begun.
                    if (std::max(span.left, spans_[number].left) != column || std::max(span.top, spans_[number].top) != row)
                        continue;
                    if (meet(boxes_[number], box) && visit(std::size_t{number})) return true;
                }
        return false;
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffff;

    struct Span {
        std::size_t left, top, right, bottom;
    };
    struct Entry {
        std::uint32_t number, next;  // next: in the same cell
    };
    // Boxes outside the area, or with NaN, belong to the cells at its edge.
    static std::size_t cell_at(double number, std::size_t count) {
        if (!(number > 0)) return 0;
        return number >= static_cast<double>(count) ? count - 1 : static_cast<std::size_t>(number);
    }
    Span span_of(const Box& box) const {
        return {cell_at((box.left - left_) / cell_, columns_), cell_at((box.top - top_) / cell_, rows_),
                cell_at((box.right - left_) / cell_, columns_), cell_at((box.bottom - top_) / cell_, rows_)};
    }

    double left_ = 0, top_ = 0, cell_ = 1;
    std::size_t columns_ = 1, rows_ = 1;
    std::vector<std::uint32_t> newest_;  // of each cell
    std::vector<Entry> entries_;
    std::vector<Box> boxes_;
    std::vector<Span> spans_;
    std::vector<std::uint32_t> broad_;  // that would be in too many cells
};

}  // namespace tactics
