// SPDX-License-Identifier: Apache-2.0
// The frame of a bar chart: the axis of values, the line where bars begin, and the names of their categories.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "filters/axis_room.h"
#include "filters/bar_places.h"
#include "filters/cell_places.h"
#include "tactics/plot.h"

namespace tactics {

struct BarFrame {
    bool level = false;  ///< bars run to the right, and the first category is at the top
    Rect field;
    double first = 0;  ///< beginning of the first slot, mm from the left of the drawing or, for level bars, from its top
    BarPlaces places;
    AxisScale values;
    std::vector<std::vector<std::string>> names;  ///< for each category, in as many lines as they need
    std::vector<std::string> name_x, name_y;      ///< of the axes, in lines
    double names_end = 0;                         ///< for level bars: where the names beside them end
    double below = 0;                             ///< mm from the field to the words below it
    double words = 0;                             ///< height of these
};

/// The parts of a frame.
struct BarRoom {
    const Sheet& sheet;
    const Clearance& clear;
    const CellPlaces& cells;
    double width = 0;   ///< mm of the drawing
    double bottom = 0;  ///< mm from its top: where the key begins
};

/// The range of the value axis: 0, all ends of bars, and of their errors.
AxisExtent extent_of_bars(const PlotBars& bars);

/// A frame with `names` at its categories and bars drawn in that way; nothing if there is no room.
std::optional<BarFrame> bar_frame(const Plot& plot, const std::vector<std::string>& names, bool level, BarLook look,
                                  const BarRoom& room);

/// Axes, ticks, and all words except those of the key.
void draw_bar_frame(const BarFrame& frame, const BarRoom& room, Drawing& drawing);

}  // namespace tactics
