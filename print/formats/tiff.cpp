// Tag Image File Format: black and white pixels in fax compression.
#include "print/fax.h"
#include "print/format.h"
#include "print/raster.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr Option kOptions[] = {
    {.name = "dpi", .type = Option::Type::number, .fallback = 300, .min = 25, .max = 2400, .unit = "dpi",
     .summary = "pixels per inch of paper", .choices = {}},
};

std::string encode(const Page& page, const Settings& settings) {
    const PixelSize size = pixels_at(page, settings.number("dpi"), "tiff");
    constexpr int kRowsPerStrip = 1024;  // a reader needs to hold no more than this at once
    FaxTiff tiff(size.width, size.height, kRowsPerStrip, size.width / page.width * kMmPerInch,
                 size.height / page.height * kMmPerInch);
    draw_rows(page, size, [&](const std::uint8_t* row) { tiff.add_row(row); });
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
    .options = kOptions,
    .encode = encode,
};

}  // namespace tactics
