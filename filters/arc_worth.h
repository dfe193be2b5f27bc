// SPDX-License-Identifier: Apache-2.0
// How likely people would have drawn an arc: what choosing goes by.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tactics/region_tree.h"

namespace tactics {

inline constexpr std::size_t kArcFeatures = 24;
using ArcFeatures = std::array<float, kArcFeatures>;

/// What is known of each arc: how sure the map and the merging are of it, on its own and among all arcs of the picture, what it
/// parts, how long it is and where. Of an arc at level 0 nothing: all 0.
std::vector<ArcFeatures> arc_features_of(const RegionTree& tree);

/// 0 to 1 for each arc, by what was fitted for the kind of map that the tree was made from.
struct ArcChances {
    std::vector<float> drawn;  ///< that at least three of five people would draw it
    std::vector<float> main;   ///< that it is on the outline of the largest thing that a person drew whole within the picture
};

ArcChances arc_chances_of(const RegionTree& tree);

}  // namespace tactics
