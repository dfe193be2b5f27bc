// SPDX-License-Identifier: Apache-2.0
// Bars over categories as a drawing.
#pragma once

#include "filters/chart.h"

namespace tactics {

/// Draws plot.bars. Five textures, which the key shows, distinguish the series. A category has its name below or beside its bars
/// or, if names have no room, a letter that the key explains. Throws Error(usage) if the bars have no room.
Drawing draw_bars(const Plot& plot, const Sheet& sheet, const ChartWish& wish, Notes& notes, ChartTold& told);

}  // namespace tactics
