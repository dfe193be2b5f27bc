// SPDX-License-Identifier: Apache-2.0
// The colours that a picture was drawn with, each with the paler pixels of its lines' borders.
#pragma once

#include <cstddef>

#include "tactics/image.h"

namespace tactics {

/// The commonest come first; at most eight.
struct InkHues {
    std::size_t count = 0;
    Image labels;  ///< the number of each pixel's hue, from 1; 0: ground, or as pale as a grid; count + 1: a mixture
};

InkHues ink_hues_of(const Image& picture);

}  // namespace tactics
