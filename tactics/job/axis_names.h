// SPDX-License-Identifier: Apache-2.0
// Placement of axis names: braille never runs upwards, and needs more distance from other braille than print from print.
#pragma once

#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// The middle of a piece of print, in any unit.
struct PrintPlace {
    Point at;
    double height = 0;  ///< height of its letters
    bool upwards = false;
    bool number = false;
    bool loose = false;      ///< it names an axis, and may stand anywhere near it
    bool elsewhere = false;  ///< it names something drawn at another place, as the words of a legend do
};

/// Moves the name of a vertical axis above the axis numbers, where transcribers put it: the numbers within a quarter of `width`
/// beside it. Without such numbers it stays. The name of a horizontal axis goes as far below its numbers as braille lines need.
/// Both become loose.
void place_axis_names(std::vector<PrintPlace>& places, double width);

}  // namespace tactics
