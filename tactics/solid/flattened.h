// SPDX-License-Identifier: Apache-2.0
// The place of a bar after it is turned into the plane about the end that holds it.
#pragma once

#include <vector>

#include "tactics/solid/flat_shape.h"

namespace tactics {

struct FlatBar {
    Point from, to;
};

/// The best first: out over the nearest corner or side of what holds it, then in across it. Where a bar is held near a corner,
/// it begins in the corner. Held far from any border: none.
///
/// The direction minimises E(t) = a (1 - cos(t - ta)) + b (1 - cos(t - tb)), a and b being the lengths of the two sides that
/// meet in the corner, and ta and tb the directions in which they would go on beyond it: along the bisector where they are
/// equal (M. Kurze, CHI 1997, step 4: "perpendicular to the bisector of the rectangular corner" is the axis), and nearer to the
/// longer one otherwise, so that a long table has its legs near to its longest direction.
std::vector<FlatBar> ways_to_flatten(const FlatShape& holder, Point held, double length);

}  // namespace tactics
