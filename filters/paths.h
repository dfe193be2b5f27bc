// SPDX-License-Identifier: Apache-2.0
// Lines put together from the pieces of a pixel graph: through junctions and over gaps, in the straightest way.
#pragma once

#include <vector>

#include "filters/pixel_graph.h"

namespace tactics {

struct PixelPath {
    std::vector<Point> points;    ///< in pixels
    bool closed = false;          ///< the first point is not repeated
    bool free[2] = {true, true};  ///< the first and last point are ends of ink, not places on another line
    int ends_at[2] = {-1, -1};    ///< the junction at the first and last point
    std::vector<int> passes;      ///< junctions that it passes through, in order
    int kind = 0;                 ///< of its chains
};

/// At each junction, the two pieces that continue most nearly straight are joined, then the next two; any remaining piece ends
/// there.
std::vector<PixelPath> join_at_junctions(const PixelGraph& graph);

/// Ends that lie at a junction are put on a line that goes through it, or all in one point; `paths` by now may be smooth.
void attach_ends(std::vector<PixelPath>& paths, const PixelGraph& graph);

/// Free ends at most `gap` pixels apart that point at each other become one line, the nearest and straightest first.
void bridge(std::vector<PixelPath>& paths, double gap);

/// Extends free ends that stop at most `gap` pixels before another line, and point at it, up to that line. An edge detector
/// leaves such gaps wherever one edge ends on another. The picture is `width` x `height` pixels.
void reach_lines(std::vector<PixelPath>& paths, double gap, int width, int height);

}  // namespace tactics
