// SPDX-License-Identifier: Apache-2.0
// Boxes sorted into the cells of a grid, so that only near ones are compared.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tactics/geometry/distance.h"

namespace tactics {

class Grid {
public:
    Grid() = default;  ///< empty, and not usable
    /// Cells are as large as boxes of the page, which is width x height, are in the mean; what is beside the page has larger
    /// ones. At most 1.6 million cells, and entries for about ten times the boxes.
    Grid(std::vector<Box> boxes, double width, double height);

    /// Calls visit(i, j) once for each pair of boxes that meet; i < j. Stops, and returns false, if `visit` returns false or
    /// after more than `most` pairs.
    template <typename Visit>
    bool pairs(std::size_t most, Visit visit) const {
        std::size_t looked = 0;
        for (std::size_t cell = 0; cell + 1 < starts_.size(); ++cell)
            for (std::size_t a = starts_[cell]; a < starts_[cell + 1]; ++a) {
                looked += starts_[cell + 1] - a;
                if (looked > most) return false;
                const std::size_t i = entries_[a];
                const Box& box = boxes_[i];
                for (std::size_t b = a + 1; b < starts_[cell + 1]; ++b) {
                    // Each pair is visited in only one of its common cells: the one where both have begun.
                    if ((begun_[a] | begun_[b]) != kBegunBothWays) continue;
                    const std::size_t j = entries_[b];
                    if (meet(box, boxes_[j]) && !visit(i, j)) return false;
                }
            }
        return true;
    }

    /// Calls visit(i) for each box that meets `box`, until it returns true; then returns true. It may visit a box several times.
    template <typename Visit>
    bool any_near(const Box& box, Visit visit) const {
        const Span span = span_of(box);
        for (std::size_t row = span.top; row <= span.bottom; ++row)
            for (std::size_t column = span.left; column <= span.right; ++column)
                for (std::size_t e = starts_[row * columns_ + column]; e < starts_[row * columns_ + column + 1]; ++e)
                    if (meet(boxes_[entries_[e]], box) && visit(std::size_t{entries_[e]})) return true;
        return false;
    }

private:
    /// Cells; there are fewer than 65,536 each way.
    struct Span {
        std::uint16_t left, top, right, bottom;
    };
    /// Cells one after the other: before 0, up to `end`, and beyond. Whatever lies farther out belongs to the first or the last.
    struct Axis {
        double cell = 1, low = 0, end = 0;
        double outer = 1;  ///< of cells before 0 and beyond `end`
        std::size_t before = 0, within = 1, beyond = 0;
        std::size_t count() const { return before + within + beyond; }
        // Called four times for each box.
        std::size_t at(double place) const {
            if (place >= 0 && place <= end) return before + cell_at(place, cell, within);
            if (!(place >= 0)) return before > 0 ? cell_at(place - low, outer, before) : 0;
            return beyond > 0 ? before + within + cell_at(place - end, outer, beyond) : before + cell_at(place, cell, within);
        }
    };
    /// Index of one of `count` cells: values outside belong to the first or the last, NaN to the first.
    static std::size_t cell_at(double place, double cell, std::size_t count) {
        const double number = place / cell;
        if (!(number > 0)) return 0;
        return number >= static_cast<double>(count) ? count - 1 : static_cast<std::size_t>(number);
    }
    static Axis axis_of(double cell, double low, double end, double high, double coarser);
    Span span_of(const Box& box) const {
        const auto narrow = [](std::size_t cell) { return static_cast<std::uint16_t>(cell); };
        return {narrow(across_.at(box.left)), narrow(down_.at(box.top)), narrow(across_.at(box.right)),
                narrow(down_.at(box.bottom))};
    }
    template <typename Visit>
    void each_cell(const Span& span, Visit visit) const {
        for (std::size_t row = span.top; row <= span.bottom; ++row)
            for (std::size_t column = span.left; column <= span.right; ++column) visit(row * columns_ + column, row, column);
    }

    static constexpr std::uint8_t kBegunAcross = 1, kBegunDown = 2, kBegunBothWays = kBegunAcross | kBegunDown;

    std::vector<Box> boxes_;
    Axis across_, down_;
    std::size_t columns_ = 1;
    std::vector<std::uint32_t> starts_;   ///< of each cell in entries_
    std::vector<std::uint32_t> entries_;  ///< boxes
    std::vector<std::uint8_t> begun_;     ///< of each entry: does its box begin in this column, in this row?
};

}  // namespace tactics
