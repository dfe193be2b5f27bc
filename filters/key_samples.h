// SPDX-License-Identifier: Apache-2.0
// Samples of a legend: what is painted beside its words, and how it looks.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "filters/dash_rows.h"
#include "filters/inked_legend.h"
#include "tactics/image.h"

namespace tactics {

constexpr int kInkOfKeys = 215;  ///< of 255 is the ground; paler is the border of something, or noise

using PixelColour = std::array<int, 3>;

struct KeySample {
    std::size_t words = 0;  ///< their number
    PixelBox box;
    bool line = false, hatch = false;
    PixelColour colour{};
    double height = 0;                    ///< of the letters beside it
    int off_ground = 0;                   ///< levels
    std::optional<DashKind> dashes = {};  ///< of a line that is not whole
};

/// Samples in a row or a column of which no two look alike. `ink` is ink_on_white of the picture.
std::vector<KeySample> key_samples_in(const Image& picture, const Image& ink, const std::vector<LegendWords>& words);

PixelColour pixel_colour(const Image& picture, int x, int y);

}  // namespace tactics
