// SPDX-License-Identifier: Apache-2.0
// A plot becomes a drawing: axes with ticks, curves, marks, contours, and a key below.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "filters/surface_sections.h"
#include "filters/ticks.h"
#include "tactics/layout/sheet.h"
#include "tactics/page.h"
#include "tactics/plot.h"
#include "tactics/text/note.h"

namespace tactics {

enum class SurfaceView : std::uint8_t {
    contours,
    sections,
    heights,  ///< as heights, in formats that have them (tactics/job/drawable.h); on paper as contours
};

/// How a plot is drawn.
struct ChartWish {
    bool grid = false;  ///< off by default: lines that are not there cannot distract a finger, and ticks show values
    SurfaceView view = SurfaceView::contours;
    int levels = 0;  ///< maximum number of contours; 0: as many as a finger can tell apart, 3 to 8
    SectionWish sections = {};
    bool told = false;  ///< also report the chart to programs (tactics/job/chart_json.h)
};

/// The data of a chart for programs.
struct ChartTold {
    std::optional<AxisPlace> x, y;     ///< nothing for an axis of categories
    bool level = false;                ///< bars run to the right, so that x has their values
    std::vector<std::string> letters;  ///< of each category; empty: their names stand there
};

/// The sheet on which a chart is drawn: that one, or, where it has a free orientation, landscape if only that has room for the
/// words at round values, or for the chart at all.
Sheet sheet_of_chart(const Plot& plot, const Sheet& sheet, const ChartWish& wish = {});

/// The chart, as large as the sheet's room below its title (upright, unless the sheet says otherwise), so that lay_out
/// keeps its millimetres. Axes are thin lines, curves normal ones or thicker, and grid lines less than axes, so that a finger
/// tells data from frame. Nothing lies over a label.
///
/// Named curves have the five line styles (line_styles.h), and the key begins each line with a sample: a finger can follow a
/// style through a crossing, which is impossible with a letter, and no letter is in its way. More than five curves are solid
/// lines with a letter each. Marks that share a symbol and a name appear in the key by that symbol, as a group; other named marks
/// have letters, since each is a separate thing. `notes` reports differences from the plot: points that have no room, fine
/// detail. Bars over categories are drawn by bar_chart.h.
///
/// Throws Error(usage) if the sheet is too small for it.
Drawing draw_chart(const Plot& plot, const Sheet& sheet, const ChartWish& wish = {}, Notes* notes = nullptr,
                   ChartTold* told = nullptr);

/// Width over height of any chart on that sheet.
double chart_aspect(const Sheet& sheet);

}  // namespace tactics
