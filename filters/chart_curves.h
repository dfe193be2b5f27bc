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
    std::vector<std::vector<Point>> lines;   ///< between gaps; for bars, their outline, their sides and their base
    std::vector<std::vector<Point>> filled;  ///< bars too low for a top separate from their base
    std::vector<Point> alone;                ///< points with a gap on both sides
    double every = 0;                        ///< mm: distance of the points through which it is drawn; 0: through all
};

/// Joins points as the curve requires. A curve that rises and falls so fast that it comes closer to itself than the medium's gap
/// is drawn through fewer points: in each stretch, the first, the last and the one with the median value of the rest. The stretch
/// grows until the curve keeps the gap, or to 12 mm. Bars stand on 0, or on the lowest value of a logarithmic axis. Throws
/// Error(usage) for bars narrower than the gap.
ChartCurve curve_on(const PlotCurve& curve, const AxisScale& across, const AxisScale& up, bool up_is_logarithmic,
                    const Medium& medium);

}  // namespace tactics
