// SPDX-License-Identifier: Apache-2.0
// The contents of a height file, before the user's wishes are applied.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tactics/readers/read.h"
#include "tactics/relief/height_words.h"

namespace tactics {

struct FoundHeights {
    int width = 0, height = 0;
    std::vector<float> values;  ///< 0 (black) to 1 (white); floating-point numbers unchanged
    bool decimal = false;
    HeightWords words;
    std::string format;  ///< "16-bit PNG"
};

/// Throws Error(failed) if it has more samples than kMostHeights.
void check_height_count(const std::string& name, long long width, long long height);

/// The words of a PNG, wherever they stand in it. A file that is damaged has those before the damage.
HeightWords png_height_words(Source& source);
/// Nothing if it is another kind of picture, which read_picture reads in 8 bits.
std::optional<FoundHeights> read_png_heights(Source& source);

HeightWords tiff_height_words(Source& source);
std::optional<FoundHeights> read_tiff_heights(Source& source);

}  // namespace tactics
