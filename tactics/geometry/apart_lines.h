// SPDX-License-Identifier: Apache-2.0
// Selects lines that a finger can tell apart, the more important first.
#pragma once

#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// Where two lines are closer than `apart` mm, middle to middle, the later one is removed; the order is that of Stroke::line,
/// thicker first, then longer first. Lines may be close where they meet. A line that runs to and fro or in circles within that
/// distance becomes straight. Remaining pieces shorter than `shortest` are also removed. Strokes keep everything but their
/// points.
std::vector<Stroke> apart_lines(std::vector<Stroke> strokes, double apart, double shortest);

}  // namespace tactics
