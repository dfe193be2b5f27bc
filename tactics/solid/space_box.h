// SPDX-License-Identifier: Apache-2.0
// Upright boxes in space.
#pragma once

#include <limits>

#include "tactics/point3.h"

namespace tactics {

/// Share of an extent by which parts of a model may be apart where they are meant to meet.
inline constexpr double kLooseShare = 0.02;

struct SpaceBox {
    Point3 low, high;
};
/// Round nothing.
inline constexpr SpaceBox kNoSpace{
    {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()},
    {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
     -std::numeric_limits<double>::infinity()}};
void take(SpaceBox& box, const Point3& at);  ///< makes it as large as needed
SpaceBox grown(const SpaceBox& box, double margin);
/// mm along the axis where they are farthest apart; 0: they meet.
double apart(const SpaceBox& a, const SpaceBox& b);

}  // namespace tactics
