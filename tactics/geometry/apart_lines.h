// SPDX-License-Identifier: Apache-2.0
// Of many lines those that a finger can tell apart, the more important first.
#pragma once

#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// Of two lines nearer than `apart` mm, middle to middle, the later one goes where it is so near; the order is that of
/// Stroke::line, the thicker first, and then the longer first. Where lines meet, they may be near. A line that goes to and fro,
/// or round about, within that becomes a straight one. What is left of a line and shorter than `shortest` goes, too. Strokes keep
/// what they are, apart from their points.
std::vector<Stroke> apart_lines(std::vector<Stroke> strokes, double apart, double shortest);

}  // namespace tactics
