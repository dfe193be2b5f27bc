// SPDX-License-Identifier: Apache-2.0
// The borders of ink: rings along the edges of pixels.
#pragma once

#include <vector>

#include "tactics/drawing.h"
#include "tactics/geometry/skeleton.h"

namespace tactics {

/// Points in pixels, one in the middle of every pixel edge between ink and white; not repeated at the end.
struct OutlineRing {
    std::vector<Point> points;
    double area = 0;    ///< square pixels that it encloses, exactly
    double extent = 0;  ///< longer side of its rectangle
};

/// A piece of 8-connected ink: its outer ring first, then its holes.
struct Outline {
    std::vector<OutlineRing> rings;
};

/// All pieces of ink, ordered by their topmost, then leftmost pixel.
std::vector<Outline> outlines_of(const InkMap& ink);

/// Moves a ring's points outwards or inwards, all by the same small amount, until it encloses `area` square pixels again.
void keep_area(std::vector<Point>& ring, double area);

}  // namespace tactics
