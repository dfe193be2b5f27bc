// SPDX-License-Identifier: Apache-2.0
// How much line a drawing of a size bears.
#pragma once

#include <cmath>

namespace tactics {

/// The side of the sheets on which the budget was found, mm.
inline constexpr double kMeasuredSide = 63;

/// mm of line on a drawing of `width` x `height` mm, if a square of 63 mm bears `line`. For other sizes nothing was measured. A
/// hand that remembers the same scene wants line in proportion to the side; a finger that wants the same room between lines, in
/// proportion to the area. The budget goes between them, as side to the 5/3: A4 has 1 m.
inline double line_budget(double line, double width, double height) {
    return line * std::pow(std::sqrt(width * height) / kMeasuredSide, 5.0 / 3);
}

}  // namespace tactics
