// SPDX-License-Identifier: Apache-2.0
// A picture as a file: an uncompressed grey TIFF, since it needs nothing to write it.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

namespace tactics::tests {

/// `grey(x, y)` at each pixel, as a TIFF 6.0 baseline file.
template <typename Grey>
std::string grey_picture(int width, int height, const Grey& grey) {
    std::string tiff("II*\0\x08\0\0\0", 8);
    const auto add = [&](std::uint32_t value, int bytes) {
        for (int i = 0; i < bytes; ++i) tiff += static_cast<char>(value >> (8 * i) & 255);
    };
    constexpr std::uint32_t kEntries = 9;
    const auto field = [&](std::uint32_t tag, std::uint32_t value) {
        add(tag, 2);
        add(4, 2);  // LONG
        add(1, 4);
        add(value, 4);
    };
    const auto w = static_cast<std::uint32_t>(width);
    const auto h = static_cast<std::uint32_t>(height);
    add(kEntries, 2);
    field(256, w);
    field(257, h);
    field(258, 8);                          // bits per sample
    field(259, 1);                          // no compression
    field(262, 1);                          // black is zero
    field(273, 8 + 2 + kEntries * 12 + 4);  // where the pixels are
    field(277, 1);                          // samples per pixel
    field(278, h);                          // rows per strip
    field(279, w * h);
    add(0, 4);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) tiff += static_cast<char>(grey(x, y));
    return tiff;
}

/// A dark disc on light ground, with some shading.
inline std::string disc_picture(int width = 240, int height = 160) {
    return grey_picture(width, height, [=](int x, int y) {
        const double distance = std::hypot(x - width / 2.0, y - height / 2.0);
        return distance < height / 3.0 ? 40 + x * 40 / width : 200 + y * 40 / height;
    });
}

}  // namespace tactics::tests
