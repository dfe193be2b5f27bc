// SPDX-License-Identifier: Apache-2.0
// A line as cubic curves with few nodes, as a person wants to move them in a drawing program.
#pragma once

#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// From where the one before it ends, with two handles; or straight to its end.
struct CurvePiece {
    bool straight = true;
    Point one, other;  ///< handles; only of one that is not straight
    Point end;
};

/// Pieces from the first point on; of a closed line the last ends where the first begins. No place of the line is farther from
/// the curves, and none of these from the line, than `tolerance` (mm, above 0). Corners stay nodes. P. J. Schneider, An algorithm
/// for automatically fitting digitized curves, Graphics Gems, 1990. Of fewer than two points none.
std::vector<CurvePiece> curves_of(const std::vector<Point>& points, bool closed, double tolerance);

}  // namespace tactics
