// SPDX-License-Identifier: Apache-2.0
// The probability that people would draw an arc, used to choose outlines.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tactics/region_tree.h"

namespace tactics {

inline constexpr std::size_t kArcFeatures = 24;
using ArcFeatures = std::array<float, kArcFeatures>;

/// Features of each arc: its strength in the map and in the merging, absolute and relative to all arcs of the picture, the
/// regions that it separates, its length and place. All are 0 for an arc at level 0.
std::vector<ArcFeatures> arc_features_of(const RegionTree& tree);

/// 0 to 1 for each arc, by the fit for the tree's kind of map.
struct ArcChances {
    std::vector<float> drawn;  ///< that at least three of five people would draw it
    std::vector<float> main;   ///< that it is on the outline of the largest thing that a person drew whole within the picture
};

ArcChances arc_chances_of(const RegionTree& tree);

}  // namespace tactics
