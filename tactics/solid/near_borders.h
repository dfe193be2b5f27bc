// SPDX-License-Identifier: Apache-2.0
// Which borders of a layout come near a place.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/geometry/growing_grid.h"
#include "tactics/solid/layout.h"

namespace tactics {

class NearBorders {
public:
    /// Of the panels that lie where they are, which must outlive it. `reach`: mm up to which places are asked for.
    NearBorders(const FlatLayout& layout, double reach);

    /// Calls visit(panel) for the places in FlatLayout::panels whose border may be that near, each perhaps several times, until
    /// it returns true; then returns true.
    template <typename Visit>
    bool any_near(Point at, Visit visit) const {
        return pieces_.any_near({at.x - reach_, at.y - reach_, at.x + reach_, at.y + reach_},
                                [&](std::size_t piece) { return visit(std::size_t{panel_[piece]}); });
    }

private:
    double reach_;
    GrowingGrid pieces_;                // boxes of short pieces of the borders, as that of a long slanted side is all of the page
    std::vector<std::uint32_t> panel_;  // of each piece
};

}  // namespace tactics
