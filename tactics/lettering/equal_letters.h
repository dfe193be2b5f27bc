// SPDX-License-Identifier: Apache-2.0
// Words in monospaced print, whose letters are all as wide as a space.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/image.h"

namespace tactics {

/// Between two letters of a row there is a word space: their middles are two letters apart, as those of the letters beside them
/// are one. `order` has the numbers of boxes by their left sides; `left` and `right` are places in it.
bool is_space_of_equal_letters(const std::vector<PixelBox>& boxes, const std::vector<std::size_t>& order, std::size_t left,
                               std::size_t right);

}  // namespace tactics
