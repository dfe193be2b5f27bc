// SPDX-License-Identifier: Apache-2.0
// Tag Image File Format: black and white pixels in fax compression.
#include "print/fax.h"
#include "print/format.h"
#include "print/raster.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr Option kTiffOptions[] = {
    {.name = "dpi",
     .type = Option::Type::number,
     .fallback = 300,
     .min = 25,
     .max = 2400,
     .unit = "dpi",
     .summary = "pixels per inch of paper"},
};

std::string encode_pages_tiff(std::span<const Page> pages, const Settings& settings) {
    const Page& first = pages.front();
    const PixelSize size = pixels_at(first, settings.number("dpi"), "tiff");
    constexpr int kRowsPerStrip = 1024;  // a reader needs to hold no more than this at once
    FaxTiff tiff(size.width, size.height, kRowsPerStrip, size.width / first.width * kMmPerInch,
                 size.height / first.height * kMmPerInch);
    const auto count = static_cast<int>(pages.size());
    for (int i = 0; i < count; ++i) {
        if (count > 1) tiff.begin_page(i, count);
        draw_rows(pages[static_cast<std::size_t>(i)], size, [&](const std::uint8_t* row) { tiff.add_row(row); });
    }
    return tiff.finish();
}

}  // namespace

extern const Format tiff_format;
const Format tiff_format{
    .name = "tiff",
    .summary = "black and white pixels in fax compression (CCITT Group 4), for print shops",
    .extensions = "tiff tif",
    .medium = "swell",
    .paper = "a4",
    .options = kTiffOptions,
    .encode_pages = encode_pages_tiff,
};

}  // namespace tactics
