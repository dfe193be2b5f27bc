// SPDX-License-Identifier: Apache-2.0
// The parts of a region tree that could be separate things, and how much each looks like one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tactics/geometry/box.h"
#include "tactics/region_tree.h"

namespace tactics {

/// Properties of any set of faces; they are additive, except for borders between its parts.
struct Bulk {
    double area = 0;                ///< square pixels
    double outline = 0;             ///< sides of pixels, the picture's frame not counted
    double sure = 0;                ///< sum along the outline of the chances
    std::array<double, 4> frame{};  ///< sides of pixels at the picture's left, top, right, bottom
    Box box = kNothing;             ///< in pixels

    double mean_chance() const { return outline > 0 ? sure / outline : 0; }
};

/// The extent of each node of the tree.
std::vector<Bulk> bulks_of(const RegionTree& tree, std::span<const float> chances);

/// Intersection over union of two boxes.
double overlap_of_boxes(const Box& a, const Box& b);

/// One or two nodes.
struct Silhouette {
    std::size_t node = 0;
    int other = -1;
    Bulk bulk;
};

/// Neighbours of which one is among the first nodes, one among the second, and none holds the other.
std::vector<Silhouette> pairs_of(const RegionTree& tree, std::span<const float> chances, const std::vector<Bulk>& bulks,
                                 const std::vector<std::size_t>& first, const std::vector<std::size_t>& second);

/// For each face, whether it is in the thing.
std::vector<bool> faces_in(const RegionTree& tree, const Silhouette& thing);

}  // namespace tactics
