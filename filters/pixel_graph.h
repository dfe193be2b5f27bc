// SPDX-License-Identifier: Apache-2.0
// A skeleton as a graph of lines that run from junction to junction.
#pragma once

#include <vector>

#include "tactics/drawing.h"
#include "tactics/geometry/skeleton.h"

namespace tactics {

/// Points in pixels, the middle of the first pixel is (0.5, 0.5).
struct PixelChain {
    std::vector<Point> points;  ///< neighbouring pixel centres, without the junctions' own pixels
    int from = -1;              ///< index of the junction at the first point; -1: the line ends there
    int to = -1;                ///< the same at the last point
    bool closed = false;        ///< a loop that meets no junction
    int kind = 0;               ///< chains of different kinds are never one line
};

struct PixelJunction {
    Point at;
    double reach = 0;  ///< pixels around it where the medial lines bend each other
};

struct PixelGraph {
    std::vector<PixelChain> chains;
    std::vector<PixelJunction> junctions;
};

/// Junctions that lie within the ink's own width of each other become one (two lines that cross make two in a skeleton).
/// Spurs shorter than `spur` pixels, or so short that they only reach a corner of the ink, are cut off, the shortest first.
/// Uses bit 1 of the skeleton's pixels as a mark.
PixelGraph graph_of(Skeleton& skeleton, double spur);

}  // namespace tactics
