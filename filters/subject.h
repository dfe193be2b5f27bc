// SPDX-License-Identifier: Apache-2.0
// The thing in a picture that a person points at or draws a box around.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tactics/region_tree.h"
#include "tactics/spot.h"

namespace tactics {

/// The faces of the tree that form the thing. `chances`: of each arc, 0 to 1. No faces if there is nothing closed.
std::vector<bool> faces_of_subject(const RegionTree& tree, std::span<const float> chances, const Spot& spot);

}  // namespace tactics
