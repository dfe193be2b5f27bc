// SPDX-License-Identifier: Apache-2.0
// Portable Network Graphics: the page as black and white pixels.
#include "print/format.h"
#include "print/one_bit_png.h"
#include "print/raster.h"
#include "tactics/readers/read.h"

namespace tactics {

namespace {

constexpr Option kPngOptions[] = {
    {.name = "dpi",
     .type = Option::Type::number,
     .fallback = 300,
     .min = 25,
     .max = 2400,
     .unit = "dpi",
     .summary = "pixels per inch of paper"},
    {.name = "width",
     .type = Option::Type::whole,
     .fallback = 0,
     .min = 0,
     .max = kMaxSide,
     .unit = "pixels",
     .summary = "exact width of the page in pixels; 0: from dpi"},
    {.name = "height",
     .type = Option::Type::whole,
     .fallback = 0,
     .min = 0,
     .max = kMaxSide,
     .unit = "pixels",
     .summary = "exact height, if a width is given; 0: from the shape of the page"},
};

std::string encode_png(const Page& page, const Settings& settings) {
    const int width = settings.whole("width"), height = settings.whole("height");
    const PixelSize size = width > 0 ? pixels_across(page, width, height, "png") : pixels_at(page, settings.number("dpi"), "png");
    OneBitPng png(size.width, size.height, size.width / page.width * 1000, size.height / page.height * 1000);
    draw_rows(page, size, [&](const std::uint8_t* row) { png.add_row(row); });
    return png.finish();
}

}  // namespace

extern const Format png_format;
const Format png_format{
    .name = "png",
    .summary = "black and white pixels for a printer's driver or the screen",
    .extensions = "png",
    .medium = "swell",
    .paper = "a4",
    .options = kPngOptions,
    .encode_page = encode_png,
};

}  // namespace tactics
