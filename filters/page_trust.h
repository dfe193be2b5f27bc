// SPDX-License-Identifier: Apache-2.0
// The trust in a page of outlines, estimated when they are chosen and calibrated on people's drawings.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "filters/outline_choice.h"
#include "tactics/drawing.h"
#include "tactics/region_tree.h"

namespace tactics {

inline constexpr std::size_t kTrustFeatures = 2;
using TrustFeatures = std::array<float, kTrustFeatures>;

/// The share of the drawn line that people would draw, and the share of people's lines that is drawn, if the probabilities of the
/// arcs are right; nothing for a page without line.
std::optional<TrustFeatures> trust_features_of(const RegionTree& tree, const Parts& parts, std::span<const float> chances);

/// The same, calibrated on people's drawings of photographs, for the tree's kind of map.
std::optional<Trust> trust_of(const RegionTree& tree, const Parts& parts, std::span<const float> chances);

}  // namespace tactics
