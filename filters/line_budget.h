// SPDX-License-Identifier: Apache-2.0
// The line budget for a drawing of a given size.
#pragma once

#include <cmath>

namespace tactics {

/// The side of the sheets on which the budget was found, mm.
inline constexpr double kMeasuredSide = 63;

/// mm of line for a drawing of `width` x `height` mm, if a square of 63 mm has `line`. Other sizes were not measured. For a hand
/// to remember the same scene, line should grow with the side; for a finger to have the same room between lines, with the area.
/// The budget lies between these two and grows with the side to the power 5/3; A4 has 1 m.
inline double line_budget(double line, double width, double height) {
    return line * std::pow(std::sqrt(width * height) / kMeasuredSide, 5.0 / 3);
}

}  // namespace tactics
