// SPDX-License-Identifier: Apache-2.0
// How far a place is from lines.
#pragma once

#include <algorithm>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/geometry/course.h"

namespace tactics::tests {

inline double distance_to(const std::vector<Stroke>& strokes, Point p) {
    double nearest = 1e9;
    for (const Stroke& stroke : strokes)
        for (std::size_t i = 0; i + (stroke.closed ? 0 : 1) < stroke.points.size(); ++i)
            nearest = std::min(nearest, distance_to_segment(p, stroke.points[i], stroke.points[(i + 1) % stroke.points.size()]));
    return nearest;
}

}  // namespace tactics::tests
