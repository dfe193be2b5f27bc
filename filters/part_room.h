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

/// What of a part is less than `gap` pixels wide goes to a neighbour, over the border that is worth less: of two lines that would
/// run side by side the better one stays. If it is slender and has one neighbour all around, it is kept as a line. The picture's
/// frame is no border. `worth`: of each pixel, how likely a line would be drawn along its left or upper side, 0 to 1.
RoomyParts with_room(std::vector<std::uint32_t> part, std::span<const float> worth, int width, int height, double gap);

}  // namespace tactics
