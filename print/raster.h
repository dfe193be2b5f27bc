// SPDX-License-Identifier: Apache-2.0
// A page as black and white pixels. A pixel is black if its centre lies in something black: there is no grey and no smoothing
// that a heater or a scanner would have to interpret later.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "tactics/page.h"

namespace tactics {

struct PixelSize {
    int width = 0;
    int height = 0;
};

/// The page's size at a resolution, at least one pixel each way. Throws Error(usage) with `format` and the largest possible
/// resolution if the size exceeds kMaxSide or kMaxPixels (read.h), so that every written file can be read again.
PixelSize pixels_at(const Page& page, double dpi, std::string_view format);
/// The page at a width and height in pixels; a height of 0 follows from the page. Throws as pixels_at does.
PixelSize pixels_across(const Page& page, int width, int height, std::string_view format);

/// A row, packed to bytes, most significant bit left, 1 = black.
using RowSink = std::function<void(const std::uint8_t* row)>;

/// Draws the page into exactly that many pixels, from the top row to the bottom; works in bands of a few MB.
void draw_rows(const Page& page, PixelSize size, const RowSink& sink);

}  // namespace tactics
