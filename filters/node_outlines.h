// SPDX-License-Identifier: Apache-2.0
// The outlines of all things in a tree.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/region_tree.h"

namespace tactics {

/// Of each node: the arcs around it.
std::vector<std::vector<std::uint32_t>> outlines_of_nodes(const RegionTree& tree);

/// Small regions are merged first, at level 0, and are no things: only what is merged above that is one.
bool is_thing(const RegionTree& tree, std::size_t node);

}  // namespace tactics
