// Edge strength that has not been thinned: where its ridges run.
#pragma once

#include "tactics/drawing.h"
#include "tactics/image.h"

namespace tactics {

/// The same map with only the pixels left that are strongest across the edge.
EdgeMap ridges_of(const EdgeMap& edges);

/// The ridge of an unthinned map beside the pixel that `at` (in pixels) lies in, by a parabola across the edge; it moves the
/// point by at most a pixel.
Point on_ridge(const EdgeMap& edges, Point at);

}  // namespace tactics
