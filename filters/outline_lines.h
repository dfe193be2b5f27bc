// SPDX-License-Identifier: Apache-2.0
// Boundaries of regions as lines for a finger: joined where they go on straight, smooth, and kept apart.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "filters/part_room.h"
#include "filters/pixel_graph.h"
#include "tactics/drawing.h"
#include "tactics/region_tree.h"

namespace tactics {

/// How an arc between two parts is drawn.
struct ArcInk {
    LineClass line = LineClass::normal;
    float strength = 0;
    bool drawn = true;
};

/// A Gaussian along a line. Towards an end it grows narrower, so that the end stays where it is.
std::vector<Point> rounded(const std::vector<Point>& points, bool closed, double sigma);

/// The middles of an arc's steps; its ends belong to its junctions.
PixelChain chain_of(const RegionArc& arc, int kind);

/// The mean of the pixels that the points of a line lie in.
float mean_along(const std::vector<Point>& points, const std::vector<float>& pixels, int width, int height);

/// The arcs between the parts and the slender things, in millimetres. `ink` is asked for each arc, whose faces are the parts;
/// `bend`: pixels, the deviation of the Gaussian along each line. What is slender is drawn thin.
Drawing lines_of_parts(const RoomyParts& parts, int width, int height, double mm_per_pixel, double bend,
                       const std::function<ArcInk(const RegionArc&)>& ink);

}  // namespace tactics
