// SPDX-License-Identifier: Apache-2.0
// The names of axes: braille never runs upwards, and stands farther from other braille than print does from print.
#pragma once

#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// Where a piece of print has its middle, in any unit.
struct PrintPlace {
    Point at;
    double height = 0;  ///< of its letters, down
    bool upwards = false;
    bool number = false;
    bool loose = false;      ///< it names an axis, wherever near that it stands
    bool elsewhere = false;  ///< it names what is drawn at another place, as the words of a legend do
};

/// The name of an upright axis goes above the numbers of that axis, where transcribers set it: those within a quarter of `width`
/// beside it. One without such numbers stays where it is. The name of a level axis stands as far below its numbers as lines of
/// braille need it. Both become loose.
void place_axis_names(std::vector<PrintPlace>& places, double width);

}  // namespace tactics
