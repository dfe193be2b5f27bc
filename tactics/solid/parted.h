// SPDX-License-Identifier: Apache-2.0
// Convex shapes that are too close, moved off each other, each no farther than it may.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tactics/geometry/convex.h"

namespace tactics {

struct PartedShape {
    Convex hull;
    double most = 0;  ///< mm that it may move; 0: it stays where it is
};

struct PartingWish {
    double gap = 0;         ///< mm, > 0: between two, and to the border of what holds them
    double touching = 0;    ///< mm, below which two places are the same
    bool sideways = false;  ///< they move along the x axis only
};

/// How far each of `shapes` moves. `pairs`: those that must not be too close, nor pass each other along either axis. `within`:
/// what holds them all, which none leaves farther than it did; null: nothing does. A gap that has no room is smaller, down to a
/// quarter; two that cannot be parted so far stay where they are, and others keep clear of them.
std::vector<Point> parted(const std::vector<PartedShape>& shapes, const std::vector<std::array<std::uint32_t, 2>>& pairs,
                          const Convex* within, const PartingWish& wish);

}  // namespace tactics
