// SPDX-License-Identifier: Apache-2.0
// How likely a part of a picture is the thing that a person means who points into it.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "filters/silhouettes.h"
#include "tactics/drawing.h"

namespace tactics {

/// Whatever holds that face: the nodes but the whole picture, and each with a neighbour.
std::vector<Silhouette> silhouettes_at(const RegionTree& tree, std::span<const float> chances, std::size_t face);

inline constexpr std::size_t kSilhouetteFeatures = 14;
using SilhouetteFeatures = std::array<double, kSilhouetteFeatures>;
/// How sure its outline is, how long it stays in the tree, size, contact with the frame, compactness, where the point is; the
/// last is 1.
SilhouetteFeatures features_of(const RegionTree& tree, const Silhouette& thing, Point point);

/// The more, the more it would overlap with what is meant, as fitted; only the order matters.
double worth_of(const RegionTree& tree, const Silhouette& thing, Point point);

}  // namespace tactics
