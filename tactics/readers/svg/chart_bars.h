// SPDX-License-Identifier: Apache-2.0
// The bars of a bar chart among what a figure shows.
#pragma once

#include <vector>

#include "tactics/readers/svg/found_page.h"

namespace tactics {

/// Fills in `bars` of the figure if there is a bar chart in it: upright rectangles on one base or on each other, not all of one
/// length, of no more than six kinds. Rectangles with a hatch that is drawn line by line are painted with it from then on, and
/// if there are bars, those lines are gone. All else stays.
void find_chart_bars(FoundPage& figure);

/// Whether this line is no more than a part of the outline of one of these bars.
bool outlines_bar(const ChartBars& bars, const std::vector<Point>& line);

}  // namespace tactics
