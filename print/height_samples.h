// SPDX-License-Identifier: Apache-2.0
// Heights as 16-bit samples.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "print/height_files.h"

namespace tactics {

/// 0 is the lowest, 65535 the highest; NaN becomes the lowest.
inline void to_samples(const HeightSheet& sheet, std::span<const float> heights, std::span<std::uint16_t> samples) {
    for (std::size_t x = 0; x < heights.size(); ++x) {
        const double part = (static_cast<double>(heights[x]) - sheet.low) / (sheet.high - sheet.low);
        samples[x] = static_cast<std::uint16_t>(part > 0 ? std::lround(std::min(part, 1.0) * 65535) : 0L);
    }
}

}  // namespace tactics
