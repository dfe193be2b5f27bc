// SPDX-License-Identifier: Apache-2.0
// Pictures at other sizes, in integers: means where they become smaller, mixtures of neighbours where they become larger.
#pragma once

#include <vector>

#include "tactics/image.h"
#include "tactics/readers/shrink.h"

namespace tactics {

/// Each side times `scale`, rounded, at least 1.
Size scaled_size(Size size, double scale);

/// Resized; the new size must not be larger in one direction and smaller in the other.
Image resized(const Image& image, Size size);

/// Between two neighbours of a row (or column): the second's share in 256ths.
inline constexpr int kWhole = 256;
struct Between {
    int first, second, share;
};

/// The neighbours of each of `count` samples in a row of `length`; each sample spans span / per of the row: sample x lies at (2x
/// + 1) * span / (2 * per) - 1/2, held within the row.
std::vector<Between> between(int count, int span, int per, int length);

}  // namespace tactics
