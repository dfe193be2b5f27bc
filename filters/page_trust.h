// SPDX-License-Identifier: Apache-2.0
// How far a page of outlines can be trusted: what is known of it when they have been chosen, beside what people drew.
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

/// What share of the line that is drawn people would draw, and what share of the line that they would draw is drawn, if the
/// chances of the arcs are right; nothing for a page without line.
std::optional<TrustFeatures> trust_features_of(const RegionTree& tree, const Parts& parts, std::span<const float> chances);

/// The same set right by what people drew of photographs, for the kind of map that the tree was made from.
std::optional<Trust> trust_of(const RegionTree& tree, const Parts& parts, std::span<const float> chances);

}  // namespace tactics
