// SPDX-License-Identifier: Apache-2.0
// Colours compared: channel by channel, and as the eye does, from sRGB to CIELAB (white D65).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "tactics/image.h"

namespace tactics {

using Lab = std::array<double, 3>;  ///< L* 0 to 100, a*, b* about -128 to 128

using PixelColour = std::array<int, 3>;

/// Of a grey picture the same level three times.
inline PixelColour pixel_colour(const Image& picture, int x, int y) {
    const std::uint8_t* at = picture.row(y) + x * picture.channels;
    return picture.channels == 3 ? PixelColour{at[0], at[1], at[2]} : PixelColour{at[0], at[0], at[0]};
}

/// The most that two colours are apart in one channel, in its levels.
inline int channels_apart(const PixelColour& a, const PixelColour& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// How much of an ink is in a pixel, 1 is all, and by how many levels of a channel it differs from such a mixture with the
/// ground.
struct InkShare {
    double share = 0, rest = 0;
};
InkShare share_of_ink(const PixelColour& pixel, const PixelColour& ground, const PixelColour& ink);

/// Channels from 0 to 255.
Lab to_lab(double red, double green, double blue);

/// All pixels of a colour picture as three planes, L* a* b* one after the other, to within 0.02; by tables.
std::vector<std::vector<float>> lab_planes(const Image& picture);

}  // namespace tactics
