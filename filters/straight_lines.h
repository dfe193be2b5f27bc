// SPDX-License-Identifier: Apache-2.0
// Axes and frames in a mask of ink.
#pragma once

#include <cstdint>
#include <span>

namespace tactics {

/// Sets to 0 what is straight along a row for a fifth of the picture, or along a column for a third: a peak is not so high.
void take_straight_lines(std::span<std::uint8_t> mask, int width);

}  // namespace tactics
