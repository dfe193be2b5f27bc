// SPDX-License-Identifier: Apache-2.0
// The grid behind a chart in a picture, whose lines are paler than axes and curves, whole, dashed or dotted.
#pragma once

#include <array>
#include <cstddef>

#include "tactics/image.h"

namespace tactics {

/// Gives the ground's colour to such lines, level and upright ones, where they do not touch darker ink. Returns how many they
/// were; fewer than three one way are none, nor are those that are close together or not evenly apart. The picture has its size
/// in mm. `ink`: ink_on_white of it.
std::size_t leave_out_pale_grid(Image& picture, const Image& ink, const std::array<int, 3>& ground);

}  // namespace tactics
