// SPDX-License-Identifier: Apache-2.0
// Where the name of a kind of bars stands, in place of a legend.
#pragma once

#include <cstddef>

#include "tactics/layout/felt_bars.h"

namespace tactics {

/// Of all bars of that look the side with most room before it, and of these the one farthest from the base; or a place within
/// one. `room`: what words need; `width` and `height` of the drawing. All in the unit of the bars.
Point place_of_bar_name(const ChartBars& bars, std::size_t look, double width, double height, double room);

}  // namespace tactics
