// SPDX-License-Identifier: Apache-2.0
// Ticks at the axes of charts with fills: thin strokes of ink, shorter than what a recipe for surfaces keeps.
#pragma once

#include <array>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// Takes ticks out of a picture, which has its size in mm, and gives them in pixels, from the middle of their axis to their end,
/// or from end to end if they cross it. At least three of a length stand at one side of a long straight line, no two of them too
/// near each other for a finger; nothing goes on from their ends.
std::vector<std::array<Point, 2>> take_tick_marks(Image& picture);

}  // namespace tactics
