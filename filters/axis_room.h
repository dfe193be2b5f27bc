// SPDX-License-Identifier: Apache-2.0
// The space that the words at an axis need, and the ticks that fit.
#pragma once

#include <string>
#include <vector>

#include "filters/chart_axis.h"
#include "filters/chart_letters.h"
#include "tactics/layout/sheet.h"

namespace tactics {

/// Size of stacked lines, mm.
double height_of(const std::vector<std::string>& lines, const Sheet& sheet);

/// The largest block of words at the ticks of an axis, however many it has.
LabelBlock widest_words(const Axis& axis, const AxisExtent& extent, const Sheet& sheet);

/// The position of an axis in the drawing, mm.
struct AxisRoom {
    double from = 0, to = 0;
    bool upright = false;
    double words = 0;  ///< between words beside each other
    double width = 0;  ///< of the drawing: words of an axis that is not upright stand between 0 and this
};

/// With as many ticks as their words have room for; where two have none, with the ends of the extent, whose words move apart
/// (`moved`), but stay below their ticks. Throws Error(usage) if there is no room for these.
AxisScale scale_for(const Axis& axis, const AxisExtent& extent, const AxisRoom& room, const Sheet& sheet);

}  // namespace tactics
