// SPDX-License-Identifier: Apache-2.0
// Underscores, as names in programs have them: "x_max", "_size".
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/lettering/ink.h"

namespace tactics {

/// Pixels that an underscore may reach below a letter beside it, as soft ink does.
inline constexpr int kSoftInk = 1;

/// Whether a bar fills the gap between two letters at their foot or below it, as one underscore or two do. Boxes are as their
/// reader sees them.
bool is_underscore_between(const PixelBox& bar, const PixelBox& a, const PixelBox& b);

/// Which of the boxes are underscores of a line: beside its letters, below their foot, and no dash of a line that goes on.
/// `letters` are numbers of boxes. In the order of the boxes.
std::vector<std::size_t> underscores_of(const std::vector<PixelBox>& boxes, const std::vector<std::size_t>& letters, int foot,
                                        int letter_height);

}  // namespace tactics
