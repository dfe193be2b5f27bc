// SPDX-License-Identifier: Apache-2.0
// A line that follows pixels made into the curve that they stand for.
#pragma once

#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// Through points about a pixel apart, each up to about half a pixel off, runs a smooth line: straight where they are
/// straight to within that, round where they are round. Corners stay within half a pixel. Points come out two pixels apart.
/// Lengths in pixels.
std::vector<Point> smooth(const std::vector<Point>& points, bool closed);

}  // namespace tactics
