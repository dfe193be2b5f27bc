// SPDX-License-Identifier: Apache-2.0
// Ink thinned to lines of one pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/image.h"

namespace tactics {

/// One byte per pixel with a white frame of one pixel around the picture, so that every pixel has eight neighbours. Bit 0: ink.
/// After thinning, the upper six bits of a peeled pixel hold its depth in the ink, so all former ink is still not 0.
struct InkMap {
    int width = 0;  ///< of the picture, without the frame
    int height = 0;
    std::ptrdiff_t stride = 0;
    std::vector<std::uint8_t> bytes;

    InkMap(int width, int height);
    std::uint8_t* row(int y) { return bytes.data() + stride * (y + 1) + 1; }
    const std::uint8_t* row(int y) const { return bytes.data() + stride * (y + 1) + 1; }
    bool ink(int x, int y) const { return (row(y)[x] & 1) != 0; }  ///< works for the frame, too
};

/// Pixels darker than 128 of a grey picture.
InkMap ink_of(const Image& grey);
/// Pixels of any strength.
InkMap ink_of(const EdgeMap& edges);

/// Neighbours in bits, clockwise: 0 N, 1 NE, 2 E, 3 SE, 4 S, 5 SW, 6 W, 7 NW; odd bits are diagonal.
struct PixelStep {
    int x;
    int y;
};
inline constexpr PixelStep kSteps[8] = {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}};

inline unsigned neighbours_of(const std::uint8_t* at, std::ptrdiff_t stride) {
    return static_cast<unsigned>((at[-stride] & 1) | (at[-stride + 1] & 1) << 1 | (at[1] & 1) << 2 | (at[stride + 1] & 1) << 3 |
                                 (at[stride] & 1) << 4 | (at[stride - 1] & 1) << 5 | (at[-1] & 1) << 6 |
                                 (at[-stride - 1] & 1) << 7);
}

struct Skeleton {
    InkMap map;
    std::vector<std::uint32_t> pixels;  ///< remaining pixels as offsets into map.bytes, row by row

    int x_of(std::uint32_t pixel) const { return static_cast<int>(pixel % static_cast<std::uint32_t>(map.stride)) - 1; }
    int y_of(std::uint32_t pixel) const { return static_cast<int>(pixel / static_cast<std::uint32_t>(map.stride)) - 1; }
    std::uint32_t pixel_at(int x, int y) const { return static_cast<std::uint32_t>(map.stride * (y + 1) + x + 1); }
    /// Whether the ink was wider than this pixel here.
    bool was_wider(std::uint32_t pixel) const {
        const std::uint8_t *at = map.bytes.data() + pixel, *above = at - map.stride, *below = at + map.stride;
        return ((above[-1] | above[0] | above[1] | at[-1] | at[1] | below[-1] | below[0] | below[1]) >> 2) != 0;
    }
    /// Half the width of the ink here, in pixels, counted in peeled layers (at most 63).
    double half_width(std::uint32_t pixel) const;
};

/// Thins the ink to lines one pixel wide, 8-connected; no piece and no hole appears or vanishes, and line ends stay. Takes time
/// in proportion to the ink, plus one visit of every pixel.
Skeleton thin(InkMap ink);

}  // namespace tactics
