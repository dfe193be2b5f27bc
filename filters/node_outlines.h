// SPDX-License-Identifier: Apache-2.0
// The outlines and the faces of all things in a tree.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/region_tree.h"

namespace tactics {

/// For each node, the arcs around it.
std::vector<std::vector<std::uint32_t>> outlines_of_nodes(const RegionTree& tree);

/// Small regions merge first, at level 0, and are no things; only nodes merged above that level are.
bool is_thing(const RegionTree& tree, std::size_t node);

/// The lowest node that contains both.
std::size_t meeting_of(const RegionTree& tree, std::size_t a, std::size_t b);

/// Faces in an order in which those of each node are adjacent.
struct FaceOrder {
    std::vector<std::size_t> first, count;  ///< of each node
    std::vector<std::uint32_t> face_at;     ///< of each place in the order

    explicit FaceOrder(const RegionTree& tree);
    bool holds(std::size_t node, std::size_t face) const {
        return first[face] >= first[node] && first[face] < first[node] + count[node];
    }
    bool meet(std::size_t a, std::size_t b) const { return first[a] < first[b] + count[b] && first[b] < first[a] + count[a]; }
};

}  // namespace tactics
