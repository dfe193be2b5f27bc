// SPDX-License-Identifier: Apache-2.0
// Points added one by one and found by position. For boxes known from the beginning, use a Grid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tactics/geometry/box.h"

namespace tactics {

class Places {
public:
    /// For points within `area`; for points outside, searches also visit distant ones. Cells are `cell` (over 0) wide and high,
    /// or larger: there are at most a million.
    Places(const Box& area, double cell);

    void add(Point point);  ///< its number is the previous count
    std::size_t size() const { return entries_.size(); }
    void shrink(std::size_t size);  ///< removes the points added last
    Point operator[](std::size_t number) const { return entries_[number].at; }

    /// Calls visit(number) for all points nearer than `reach`, and for others in the same cells, until it returns true; then
    /// returns true. Cells come row by row; in each, the newest point comes first.
    template <typename Visit>
    bool any_near(Point point, double reach, Visit visit) const {
        const std::size_t left = column(point.x - reach), right = column(point.x + reach);
        const std::size_t top = row(point.y - reach), bottom = row(point.y + reach);
        for (std::size_t y = top; y <= bottom; ++y)
            for (std::size_t x = left; x <= right; ++x)
                for (std::uint32_t i = newest_[y * columns_ + x]; i != kNone; i = entries_[i].next)
                    if (visit(std::size_t{i})) return true;
        return false;
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffff;

    struct Entry {
        Point at;
        std::uint32_t next;  // in the same cell
    };
    // Points outside the area, or NaN, belong to the cells at its edge.
    static std::size_t cell_at(double number, std::size_t count) {
        if (!(number > 0)) return 0;
        return number >= static_cast<double>(count) ? count - 1 : static_cast<std::size_t>(number);
    }
    std::size_t column(double x) const { return cell_at((x - left_) / cell_, columns_); }
    std::size_t row(double y) const { return cell_at((y - top_) / cell_, rows_); }
    std::size_t index_of(Point point) const { return row(point.y) * columns_ + column(point.x); }

    double left_, top_, cell_;
    std::size_t columns_, rows_;
    std::vector<std::uint32_t> newest_;  // of each cell
    std::vector<Entry> entries_;
};

}  // namespace tactics
