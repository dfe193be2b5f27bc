// SPDX-License-Identifier: Apache-2.0
// Error bars of charts and whiskers of boxes: thin strokes of ink, level or upright, shorter than what a recipe for surfaces
// keeps.
#pragma once

#include <array>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// Takes error bars and whiskers out of a picture, which has its size in mm, and puts what is beside them in their place, so that
/// a bar's end and its colour go on behind them. Gives their stems and caps, from end to end, in pixels. An error bar crosses
/// where a bar ends and has two caps alike, or none; a whisker has one and begins at a border. What is dark on dark, or wider
/// than a line, is none; neither are letters, which cross nothing.
std::vector<std::array<Point, 2>> take_error_bars(Image& picture);

}  // namespace tactics
