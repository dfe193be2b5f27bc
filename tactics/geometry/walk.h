// SPDX-License-Identifier: Apache-2.0
// A walk along a line in even steps.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// Goes along a line from its beginning and never back, so that many places of a long line are found in one pass. The points, at
/// least one, must outlive it.
class Walk {
public:
    Walk(std::span<const Point> points, bool closed);

    /// The point at that distance from the beginning (mm, along the line); beyond the end: the end. Distances must not decrease
    /// between calls.
    Point to(double along);

private:
    Point end_of_side() const { return points_[side_ + 1 == points_.size() ? 0 : side_ + 1]; }

    std::span<const Point> points_;
    std::size_t sides_;
    std::size_t side_ = 0;
    double passed_ = 0;  // length of the sides before this one
    double length_;      // of this one
};

/// The part of a line between two distances from its beginning, mm, with all points in between; for a closed line `to` may exceed
/// its length. Empty if there is no such part.
std::vector<Point> part_of(std::span<const Point> points, bool closed, double from, double to);

}  // namespace tactics
