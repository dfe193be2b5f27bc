// SPDX-License-Identifier: Apache-2.0
// Pixels: readers return them, and the filters before `trace` work on them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tactics {

/// A picture of 8-bit samples, row by row from the top left, channels interleaved, no padding.
/// Grey is sRGB-coded luma, Y' = 0.299 R' + 0.587 G' + 0.114 B' (ITU-R BT.601, what JPEG stores): 0 black, 255 white.
/// Drawings made of pixels are black (0) lines on white (255), as printed.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 1;         ///< 1 grey, 3 red green blue (sRGB)
    double mm_per_pixel = 0;  ///< size of a pixel on the page; pixels are square; 0 until the picture is placed
    std::vector<std::uint8_t> pixels;

    std::size_t row_bytes() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels); }
    std::uint8_t* row(int y) { return pixels.data() + row_bytes() * static_cast<std::size_t>(y); }
    const std::uint8_t* row(int y) const { return pixels.data() + row_bytes() * static_cast<std::size_t>(y); }
};

/// A rectangle of pixels: includes left and top, excludes right and bottom.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;

    int width() const { return right - left; }
    int height() const { return bottom - top; }
    bool operator==(const PixelBox&) const = default;
};
/// The smallest box that holds both.
inline PixelBox around(const PixelBox& a, const PixelBox& b) {
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom)};
}
/// Whether they have a pixel in common.
inline bool overlap(const PixelBox& a, const PixelBox& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}
/// All pixels of a picture of that size.
inline PixelBox all_of(int width, int height) { return {0, 0, width, height}; }

/// An image of that shape, every sample `value`.
Image make_image(int width, int height, int channels, double mm_per_pixel, std::uint8_t value);

/// The grey of a colour: BT.601 weights in 16-bit fixed point, rounded. They add up to 65536, so white stays 255.
inline std::uint8_t luma(const std::uint8_t* rgb) {
    return static_cast<std::uint8_t>((19595u * rgb[0] + 38470u * rgb[1] + 7471u * rgb[2] + 32768u) >> 16);
}

/// The linear light of an sRGB channel value; both from 0 to 1 (IEC 61966-2-1).
double srgb_light(double coded);

/// The grey version (luma of each pixel); a grey image is returned as it is.
Image to_grey(Image image);

/// How strongly a picture changes at each pixel: the response of an edge detector before thresholding.
///
/// `strength` is in grey levels (0-255) and is calibrated: the height of the straight step between two flat regions that would
/// give this response. So a threshold means the same for every detector, blur and resolution.
struct EdgeMap {
    int width = 0;
    int height = 0;
    double mm_per_pixel = 0;
    bool thinned = false;         ///< only ridge pixels are non-zero (non-maximum suppression was applied)
    std::vector<float> strength;  ///< width*height, >= 0, finite
    std::vector<float> normal;    ///< width*height, direction across the edge in radians [0, pi), y down; may be empty
    std::optional<float>
        noise{};  ///< scale of the strengths that noise alone causes (filters/edge_noise.h), 0 for none; empty if not measured
};

/// The edge map as a grey picture: strength 0 is white (255), the strongest edge is black (0).
Image to_picture(const EdgeMap& edges);

}  // namespace tactics
