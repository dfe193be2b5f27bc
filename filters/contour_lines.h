// SPDX-License-Identifier: Apache-2.0
// Lines of equal height on a surface.
#pragma once

#include <vector>

#include "tactics/plot.h"

namespace tactics {

/// One line of a level; a closed one does not repeat its first point.
struct ContourLine {
    std::vector<PlotPoint> points;
    bool closed = false;
};

/// Marching squares (W. Lorensen and H. Cline, 1987, in the plane): the lines that part the samples of at least that height from
/// those below it. Each point lies on a side between two samples, in proportion to their heights; where a square has its high
/// corners across from each other, the mean of the four tells which belong together. A square with an unknown corner has no line,
/// so lines end there and at the surface's edges; all others are closed. In the order of the grid; higher is on no particular
/// side.
std::vector<ContourLine> contour_lines(const PlotSurface& surface, double level);

/// Round heights strictly between the lowest and the highest known one, at most `most` (>= 3); fewer than 3 where there are none.
std::vector<double> contour_levels(const PlotSurface& surface, int most);

}  // namespace tactics
