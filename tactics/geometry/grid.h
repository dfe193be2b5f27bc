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
    Grid() = default;  ///< empty, and not to be asked
    /// Cells are as large as boxes of the page, which is width x height, are in the mean; what is beside the page has larger
    /// ones. At most 1.6 million cells, and entries for about ten times the boxes.
    Grid(std::vector<Box> boxes, double width, double height);

    /// Calls visit(i, j) once for each pair of boxes that meet; i < j. Gives up, and gives false, when `visit` gives false
    /// or when more than `most` pairs were looked at.
    template <typename Visit>
    bool pairs(std::size_t most, Visit visit) const {
        std::size_t looked = 0;
        for (std::size_t cell = 0; cell + 1 < starts_.size(); ++cell)
            for (std::size_t a = starts_[cell]; a < starts_[cell + 1]; ++a) {
                looked += starts_[cell + 1] - a;
                if (looked > most) return false;
                for (std::size_t b = a + 1; b < starts_[cell + 1]; ++b) {
                    const std::size_t i = entries_[a], j = entries_[b];
                    if (home_of(i, j) != cell || !meet(boxes_[i], boxes_[j])) continue;
                    if (!visit(i, j)) return false;
                }
            }
        return true;
    }

    /// Calls visit(i) for each box that meets `box`, until it gives true; then gives true. A box may come up several times.
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
        std::size_t at(double place) const;
    };
    static Axis axis_of(double cell, double low, double end, double high, double coarser);
    Span span_of(const Box& box) const;
    /// The one cell, of all that both are in, where the pair is looked at: where both have begun.
    std::size_t home_of(std::size_t i, std::size_t j) const {
        const Span &a = spans_[i], &b = spans_[j];
        return std::size_t{std::max(a.top, b.top)} * columns_ + std::max(a.left, b.left);
    }

    std::vector<Box> boxes_;
    Axis across_, down_;
    std::size_t columns_ = 1;
    std::vector<Span> spans_;
    std::vector<std::uint32_t> starts_;  ///< of each cell in entries_
    std::vector<std::uint32_t> entries_;
};

}  // namespace tactics
