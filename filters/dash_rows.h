// SPDX-License-Identifier: Apache-2.0
// Dashed and dotted lines of a picture of ink: rows of small thin pieces with gaps that are alike.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "filters/components.h"
#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// What a piece of ink may be to be a dash, in pixels.
struct DashLimits {
    double longest = 0, widest = 0, gap = 0;
};

/// A line of at least four dashes, in pixels; or of two or three that lead from one thing to another, as whiskers of boxes do.
struct DashRow {
    std::vector<Point> points;  ///< both ends of each dash, one behind the other; the outermost on what they stop close before
    double width = 0;           ///< of most of its dashes
    std::vector<Run> ink;
    bool leads = false;  ///< the second
};

/// Darker than 128 is ink. A line may turn by up to 30 degrees from dash to dash. Of more than 4000 pieces that could be dashes
/// none is: it is a pattern or noise.
std::vector<DashRow> dash_rows_in(const Image& ink, const DashLimits& limits);

}  // namespace tactics
