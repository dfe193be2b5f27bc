// SPDX-License-Identifier: Apache-2.0
// Lines of a plot, and the naive twin of what tells how far they are.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tactics/haptics/scenes/plot_frame.h"

namespace tactics {

using Line = std::vector<Point>;

/// The nearest place of all, one segment after the other.
inline double naive_distance(const std::vector<Line>& lines, const Point3& at) {
    double least = INFINITY;
    for (const Line& line : lines)
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const Point a = line[i], b = line[i + 1];
            const double dx = b.x - a.x, dy = b.y - a.y;
            const double t = std::clamp(((at.x - a.x) * dx + (at.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
            least = std::min(least, std::hypot(at.x - a.x - t * dx, at.y - a.y - t * dy, at.z));
        }
    return least;
}

inline PlotFrame frame() { return {{0, 10, false, {0, 2, 4, 6, 8, 10}}, {-5, 5, false, {-5, 0, 5}}, {}, 120, 80, 0}; }

}  // namespace tactics
