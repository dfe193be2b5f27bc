// SPDX-License-Identifier: Apache-2.0
// Ridges of an edge map: thin lines where the strength is greatest, and the threshold that keeps the connected ones.
#pragma once

#include <cstddef>
#include <optional>

#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// Of its strength and its normal.
inline std::size_t pixel_index(const EdgeMap& map, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(x);
}

/// Non-maximum suppression (J. Canny 1986): keeps a pixel only where its strength is greatest across the edge. Without
/// normals the edge runs across the way in which the strength is bent most. Of a map as a
/// detector gives it, the strength must also fall off to both sides within `sigma` pixels, the blur that it was made with; a
/// map that was cut (no sigma) falls off where it was cut.
EdgeMap thin_edges(const EdgeMap& edges, std::optional<double> sigma);

/// The ridge of a map that is not thinned beside the pixel that `at` (in pixels) lies in, by a parabola across the edge; it
/// moves the point by at most a pixel.
Point on_ridge(const EdgeMap& edges, Point at);

/// Hysteresis (J. Canny 1986): keeps the 8-connected pieces of strength >= low that reach `high` somewhere;
/// everything else becomes 0.
EdgeMap keep_connected(EdgeMap edges, float low, float high);

}  // namespace tactics
