// SPDX-License-Identifier: Apache-2.0
// The frame of a chart: its axes, their ticks and names, and the field between them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "filters/chart_axis.h"
#include "filters/chart_letters.h"
#include "tactics/layout/sheet.h"

namespace tactics {

struct ChartFrame {
    Rect field;      ///< between the axes
    double top = 0;  ///< where the words above the field end
    AxisScale across, up;
    std::vector<std::string> name_x, name_y;  ///< in as many lines as they need
    double below = 0;                         ///< mm from the axis to where its ticks' words begin
    double ticks_x = 0;                       ///< height of these
};

/// In a space of that width from the top down to `bottom`, with as many ticks as their words have room for. Throws Error(usage)
/// if it is too small to be read by touch, or if there is nothing to plot.
ChartFrame frame_for(const Plot& plot, const Sheet& sheet, const Clearance& clear, double width, double bottom);

/// From each tick through the field, level ones first.
std::vector<std::pair<Point, Point>> grid_lines(const ChartFrame& frame);

void draw_axes(const ChartFrame& frame, const Clearance& clear, Drawing& drawing);
void draw_names(const ChartFrame& frame, const Sheet& sheet, Drawing& drawing);

}  // namespace tactics
