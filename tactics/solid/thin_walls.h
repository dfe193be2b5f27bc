// SPDX-License-Identifier: Apache-2.0
// Walls that are too thin to be felt as two lines, as those of a wine glass that is cut through.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// A line as it lies in a drawing.
struct LaidLine {
    std::vector<Point> points;
    bool closed = false;
};

/// Leaves out what lies closer than `apart`, mm, to the outer sides; where a line comes in from there, it is joined to them. What
/// is within `touching` of the border that `outline` is, is outer itself and stays. Returns how many stretches are left out.
std::size_t leave_out_inner(std::vector<LaidLine>& lines, const std::vector<std::vector<Point>>& outline, double touching,
                            double apart);

}  // namespace tactics
