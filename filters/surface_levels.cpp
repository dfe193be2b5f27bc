// SPDX-License-Identifier: Apache-2.0
#include "filters/surface_levels.h"

#include <utility>

#include "filters/chart_axis.h"
#include "filters/contour_lines.h"

namespace tactics {

Plot levels_of(const Plot& plot, const PlotSurface& surface, const std::vector<double>& heights) {
    Plot levels{plot.title, plot.x, plot.y, {}, {}};
    for (const double height : heights) {
        PlotCurve curve{told_value(plot.z, height), {}};
        for (const ContourLine& line : contour_lines(surface, height)) {
            if (!curve.points.empty()) curve.gaps.push_back(curve.points.size());
            curve.points.insert(curve.points.end(), line.points.begin(), line.points.end());
            if (line.closed) curve.points.push_back(line.points.front());
        }
        if (!curve.points.empty()) levels.curves.push_back(std::move(curve));
    }
    return levels;
}

}  // namespace tactics
