// SPDX-License-Identifier: Apache-2.0
// Where regions meet: the boundaries of a label map as a planar graph of arcs and junctions.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tactics/region_tree.h"

namespace tactics {

struct PlanarMap {
    std::vector<Point> junctions;
    std::vector<RegionArc> arcs;  ///< courses and faces; nothing is known of their strength
};

/// Arcs run along the edges of pixels between two labels; the picture's frame has none, but where a boundary comes to it is a
/// junction. In the order of their topmost, then leftmost starting point; loops last.
PlanarMap planar_map_of(std::span<const std::uint32_t> labels, int width, int height);

}  // namespace tactics
