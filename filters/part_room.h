// SPDX-License-Identifier: Apache-2.0
// Parts of a picture made so wide everywhere that a finger can tell their two sides.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tactics/geometry/skeleton.h"

namespace tactics {

struct RoomyParts {
    std::vector<std::uint32_t> part;  ///< of each pixel
    InkMap slender;                   ///< what was too thin to have two sides, and long: a mast, a tail; to be drawn as one line
};

/// Gives parts narrower than `gap` pixels to a neighbour, across the border of less worth: of two lines that would run side by
/// side, the better one stays. A slender part with a single neighbour around it is kept as a line. The picture's frame is no
/// border. `worth`: for each pixel, the probability of a line along its left or upper side, 0 to 1.
RoomyParts with_room(std::vector<std::uint32_t> part, std::span<const float> worth, int width, int height, double gap);

}  // namespace tactics
