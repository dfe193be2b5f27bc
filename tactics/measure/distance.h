// SPDX-License-Identifier: Apache-2.0
// The distance of each pixel of a map from the nearest pixel of a set.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "tactics/measure/matching.h"

namespace tactics {

/// The distance to a set of which there is none.
inline constexpr std::int64_t kNoDistance = std::numeric_limits<std::int64_t>::max();

/// Squares of the distances in pixels, exact, row by row; kNoDistance everywhere if the set is empty. Takes time in proportion to
/// the map (A. Meijster, J. Roerdink, W. Hesselink 2000).
std::vector<std::int64_t> squared_distances(const PixelSet& set);

}  // namespace tactics
