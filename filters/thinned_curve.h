// SPDX-License-Identifier: Apache-2.0
// A curve of very many points, with no more of them than a page can show.
#pragma once

#include <vector>

#include "tactics/drawing.h"

namespace tactics {

/// The same line on paper: of each run of points that are in one column of `width` mm (over 0), the first, the lowest, the
/// highest and the last stay, in their order (the M4 aggregation: U. Jugel et al., "M4: A Visualization-Oriented Time Series Data
/// Aggregation", Proc. VLDB Endowment 7(10), 2014). So no point is farther than `width` from the line, and what moves from left
/// to right has at most 4 points a column. A curve that goes to and fro keeps its way.
std::vector<Point> thinned_curve(std::vector<Point> points, double width);

/// Finer than swell paper, embossers and fingers.
inline constexpr double kCurveColumn = 0.1;  // mm

}  // namespace tactics
