// SPDX-License-Identifier: Apache-2.0
// Straight sides put together to the strokes that a pen would draw.
#pragma once

#include <vector>

#include "tactics/drawing.h"

namespace tactics {

struct DrawnSide {
    Point from, to;
    LineClass line = LineClass::normal;
    bool twice = false;  ///< it is shown somewhere else, too: dashed
};

/// Each line once: sides on the same straight line become one where they overlap or touch, no farther apart than `touching`, mm.
/// A line that is there whole is no dashed one.
std::vector<DrawnSide> merged(const std::vector<DrawnSide>& sides, double touching);

/// Sides that meet end to end, two of a kind at a place, become one stroke.
std::vector<Stroke> joined(const std::vector<DrawnSide>& sides, double touching);

}  // namespace tactics
