// SPDX-License-Identifier: Apache-2.0
// What of a line lies within a rectangle.
#pragma once

#include <vector>

#include "tactics/drawing.h"
#include "tactics/page.h"

namespace tactics {

/// The parts of a line within, in their order. A closed one that is cut comes in parts that are not, the first and the last of
/// them meeting where it began if that is within.
std::vector<std::vector<Point>> clipped(const std::vector<Point>& points, bool closed, const Rect& rect);

}  // namespace tactics
