// SPDX-License-Identifier: Apache-2.0
// A plot becomes a drawing: axes with ticks, curves, marks with a letter each, and a key below.
#pragma once

#include "tactics/layout/sheet.h"
#include "tactics/page.h"
#include "tactics/plot.h"

namespace tactics {

/// The chart, as large as the sheet's room below its title (upright, unless the sheet says otherwise), so that lay_out
/// keeps its millimetres. Axes are thin lines, curves normal ones, so that a finger tells data from frame. Nothing lies
/// over a label. Throws Error(usage) if the sheet is too small for it.
Drawing draw_chart(const Plot& plot, const Sheet& sheet);

}  // namespace tactics
