// SPDX-License-Identifier: Apache-2.0
// Level lines through shapes: where a line across the page lies within them.
#pragma once

#include <utility>
#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// From x to x, mm; empty if the first is not smaller.
using Span = std::pair<double, double>;

/// Where the level line at `y` is within `reach` of the straight line from `a` to `b`: one span, since that is convex. False:
/// nowhere.
bool span_within(Point a, Point b, double reach, double y, Span& span);

/// `spans` minus `taken`. Both in ascending order; `spans` must not overlap, `taken` may.
std::vector<Span> without(const std::vector<Span>& spans, const std::vector<Span>& taken);

}  // namespace tactics
