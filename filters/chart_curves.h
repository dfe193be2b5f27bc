// SPDX-License-Identifier: Apache-2.0
// A curve of a plot as lines in mm, no finer than a finger can follow.
#pragma once

#include <string>
#include <vector>

#include "filters/chart_axis.h"
#include "tactics/drawing.h"
#include "tactics/medium.h"

namespace tactics {

struct ChartCurve {
    std::vector<std::vector<Point>> lines;   ///< between gaps; of bars their outline, their sides and what they stand on
    std::vector<std::vector<Point>> filled;  ///< bars that are too low to have a top apart from what they stand on
    std::vector<Point> alone;                ///< points with a gap on both sides
    double every = 0;                        ///< mm: it is drawn through one point so often; 0: through all
};

/// Points are joined as the curve says. One that comes nearer to itself than the medium's gap, from left to right up and down,
/// goes through fewer of its points: of each so many mm the first, the last and that with the middle value of the rest, until it
/// keeps the gap or 12 mm are reached. Bars stand on 0, on a logarithmic axis on its lowest value. Throws Error(usage) for bars
/// that are narrower than the gap.
ChartCurve curve_on(const PlotCurve& curve, const AxisScale& across, const AxisScale& up, bool up_is_logarithmic,
                    const Medium& medium);

}  // namespace tactics
