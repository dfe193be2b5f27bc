// SPDX-License-Identifier: Apache-2.0
// Samples of a legend: what is painted beside its words, and how it looks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "filters/dash_rows.h"
#include "filters/inked_legend.h"
#include "filters/lab.h"
#include "tactics/image.h"

namespace tactics {

constexpr int kInkOfKeys = 215;  ///< of 255 is the ground; paler is the border of something, or noise

/// How different they are, 0 for the same: 0.7 if one repeats after twice as much, and by how much more of one is ink.
double unlike(const DashLengths& a, const DashLengths& b);

inline bool is_grey(const PixelColour& c) {
    constexpr int kColour = 40;  // levels between the channels of what is not
    return *std::max_element(c.begin(), c.end()) - *std::min_element(c.begin(), c.end()) < kColour;
}

struct KeySample {
    std::size_t words = 0;  ///< their number
    PixelBox box;
    bool line = false, hatch = false;
    PixelColour colour{};
    double height = 0;                    ///< of the letters beside it
    int off_ground = 0;                   ///< levels
    std::optional<DashKind> dashes = {};  ///< of a line that is not whole
    DashLengths lengths = {};             ///< its
};

/// Samples in a row or a column. `ink` is ink_on_white of the picture.
std::vector<KeySample> key_samples_in(const Image& picture, const Image& ink, const std::vector<LegendWords>& words);

/// Without those that look like another one.
std::vector<KeySample> unlike_others(const std::vector<KeySample>& samples);

}  // namespace tactics
