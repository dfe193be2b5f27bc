// SPDX-License-Identifier: Apache-2.0
#include "tactics/image.h"

#include <algorithm>
#include <cmath>

namespace tactics {

Image make_image(int width, int height, int channels, double mm_per_pixel, std::uint8_t value) {
    Image image;
    image.width = width;
    image.height = height;
    image.channels = channels;
    image.mm_per_pixel = mm_per_pixel;
    image.pixels.assign(image.row_bytes() * static_cast<std::size_t>(height), value);
    return image;
}

double srgb_light(double coded) { return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4); }

Image to_grey(Image image) {
    if (image.channels == 1) return image;
    // In place: grey pixel i is written at or before the colour pixel it is made of.
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const std::uint8_t* from = image.pixels.data();
    std::uint8_t* to = image.pixels.data();
    for (std::size_t i = 0; i < count; ++i, from += 3) to[i] = luma(from);
    image.pixels.resize(count);
    image.channels = 1;
    return image;
}

Image to_picture(const EdgeMap& edges) {
    Image image = make_image(edges.width, edges.height, 1, edges.mm_per_pixel, 255);
    float peak = 0;
    for (const float s : edges.strength) peak = std::max(peak, s);
    if (peak <= 0) return image;
    const float scale = 255.0f / peak;
    for (std::size_t i = 0; i < edges.strength.size(); ++i)
        image.pixels[i] = static_cast<std::uint8_t>(255 - std::lround(edges.strength[i] * scale));
    return image;
}

}  // namespace tactics
