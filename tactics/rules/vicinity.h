// SPDX-License-Identifier: Apache-2.0
// Parts of a page, to the next 2 mm.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/geometry/distance.h"

namespace tactics {

class Vicinity {
public:
    Vicinity(double width, double height);

    void add(const Box& box);
    /// In one of the boxes, or so near that it does not matter. What lies outside width x height counts to the edge.
    bool holds(Point point) const { return cells_[row_of(point.y) * columns_ + column_of(point.x)]; }

private:
    std::size_t column_of(double x) const;
    std::size_t row_of(double y) const;

    double cell_ = 1;
    std::size_t columns_ = 1, rows_ = 1;
    std::vector<bool> cells_;
};

}  // namespace tactics
