// SPDX-License-Identifier: Apache-2.0
// Points as vectors of the plane.
#pragma once

#include <cmath>

#include "tactics/drawing.h"

namespace tactics {

inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
inline double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

/// Of the angle between them; 1 if one has no length.
inline double cosine(Point a, Point b) {
    const double lengths = std::hypot(a.x, a.y) * std::hypot(b.x, b.y);
    return lengths > 0 ? dot(a, b) / lengths : 1;
}

}  // namespace tactics
