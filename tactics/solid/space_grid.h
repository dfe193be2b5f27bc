// SPDX-License-Identifier: Apache-2.0
// Upright boxes in space, found again by where they are, so that only near ones are compared.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/geometry/grid.h"
#include "tactics/solid/space_box.h"

namespace tactics {

class SpaceGrid {
public:
    explicit SpaceGrid(std::vector<SpaceBox> boxes);

    /// Calls visit(place) for each box that meets `box`, until it gives true; then gives true. A box may come up several times.
    template <typename Visit>
    bool any_near(const SpaceBox& box, Visit visit) const {
        return !boxes_.empty() && grid_.any_near(flat(box), [&](std::size_t place) {
            return !(apart(boxes_[place], box) > 0) && visit(static_cast<std::uint32_t>(place));
        });
    }
    /// All that meet `box`, each once and in their order.
    std::vector<std::uint32_t> near(const SpaceBox& box) const;

private:
    Box flat(const SpaceBox& box) const;

    std::vector<SpaceBox> boxes_;
    double Point3::*across_ = &Point3::x;  // the two axes along which boxes are told apart best
    double Point3::*down_ = &Point3::y;
    double left_ = 0, top_ = 0, scale_ = 1;  // into the grid
    Grid grid_;
};

}  // namespace tactics
