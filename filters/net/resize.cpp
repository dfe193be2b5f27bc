// SPDX-License-Identifier: Apache-2.0
#include "filters/net/resize.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tactics {

Size scaled_size(Size size, double scale) {
    const auto scaled = [&](int side) { return std::max(1, static_cast<int>(std::lround(side * scale))); };
    return {scaled(size.width), scaled(size.height)};
}

std::vector<Between> between(int count, int span, int per, int length) {
    std::vector<Between> samples;
    samples.reserve(static_cast<std::size_t>(count));
    for (std::int64_t x = 0; x < count; ++x) {
        const std::int64_t at = (2 * x + 1) * span * (kWhole / 2) / per - kWhole / 2;
        const std::int64_t held = std::clamp<std::int64_t>(at, 0, static_cast<std::int64_t>(length - 1) * kWhole);
        const auto first = static_cast<int>(held / kWhole);
        samples.push_back({first, std::min(first + 1, length - 1), static_cast<int>(held % kWhole)});
    }
    return samples;
}

namespace {

Image enlarged(const Image& image, Size size) {
    Image large = make_image(size.width, size.height, image.channels, 0, 0);
    const std::vector<Between> columns = between(size.width, image.width, size.width, image.width),
                               rows = between(size.height, image.height, size.height, image.height);
    std::vector<int> mixed(image.row_bytes());
    for (int y = 0; y < size.height; ++y) {
        const Between& at = rows[static_cast<std::size_t>(y)];
        const std::uint8_t *upper = image.row(at.first), *lower = image.row(at.second);
        for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i] = upper[i] * (kWhole - at.share) + lower[i] * at.share;
        std::uint8_t* out = large.row(y);
        for (const Between& column : columns)
            for (int c = 0; c < image.channels; ++c) {
                const int left = mixed[static_cast<std::size_t>(column.first * image.channels + c)],
                          right = mixed[static_cast<std::size_t>(column.second * image.channels + c)];
                *out++ = static_cast<std::uint8_t>((left * (kWhole - column.share) + right * column.share + (1 << 15)) >> 16);
            }
    }
    return large;
}

}  // namespace

Image resized(const Image& image, Size size) {
    if (size.width > image.width || size.height > image.height) return enlarged(image, size);
    RowShrinker<std::uint8_t> shrinker({image.width, image.height}, size, image.channels);
    for (int y = 0; y < image.height; ++y) shrinker.add(image.row(y));
    Image small = make_image(0, 0, image.channels, 0, 0);
    small.width = size.width;
    small.height = size.height;
    small.pixels = shrinker.take();
    return small;
}

}  // namespace tactics
