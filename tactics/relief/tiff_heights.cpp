// SPDX-License-Identifier: Apache-2.0
// Grey TIFF of 16 bits or of 32-bit decimal numbers whole, and what TIFF files say of heights.
#include <cstring>

#include "tactics/readers/tiff_file.h"
#include "tactics/readers/tiff_rows.h"
#include "tactics/relief/found_heights.h"

namespace tactics {

namespace {

constexpr std::size_t kMostText = 4096;

HeightWords words_of(const TiffFile& file) {
    HeightWords words;
    const char* text = nullptr;
    if (TIFFGetField(file.get(), TIFFTAG_IMAGEDESCRIPTION, &text) != 0 && text != nullptr)
        words = height_words({text, strnlen(text, kMostText)});
    float across = 0, down = 0;
    std::uint16_t unit = RESUNIT_INCH;
    TIFFGetField(file.get(), TIFFTAG_XRESOLUTION, &across);
    TIFFGetField(file.get(), TIFFTAG_YRESOLUTION, &down);
    TIFFGetFieldDefaulted(file.get(), TIFFTAG_RESOLUTIONUNIT, &unit);
    const double mm = unit == RESUNIT_INCH ? 25.4 : unit == RESUNIT_CENTIMETER ? 10 : 0;
    if (across == down && across > 0) words.resolution_pitch = mm / static_cast<double>(across);
    return words;
}

}  // namespace

HeightWords tiff_height_words(Source& source) {
    TiffFile file(source);
    file.open();
    return words_of(file);
}

std::optional<FoundHeights> read_tiff_heights(Source& source) {
    TiffFile file(source);
    file.open();
    const TiffTags& tags = file.tags();
    const bool decimal = tags.bits == 32 && tags.format == SAMPLEFORMAT_IEEEFP;
    const bool whole = tags.bits == 16 && (tags.format == SAMPLEFORMAT_UINT || tags.format == SAMPLEFORMAT_VOID);
    const bool white_is_zero = tags.photometric == PHOTOMETRIC_MINISWHITE;
    const bool grey = tags.samples == 1 && (tags.photometric == PHOTOMETRIC_MINISBLACK || (white_is_zero && whole));
    if (!grey || !(decimal || whole) || tags.orientation != 1 || tags.preview) return std::nullopt;
    check_height_count(source.name, tags.width, tags.height);
    FoundHeights found{static_cast<int>(tags.width),
                       static_cast<int>(tags.height),
                       {},
                       decimal,
                       words_of(file),
                       decimal ? "32-bit decimal TIFF" : "16-bit TIFF"};
    const std::size_t width = tags.width;
    found.values.resize(width * tags.height);
    TiffRows rows(file);
    std::vector<std::uint16_t> samples(width);
    for (std::uint32_t y = 0; y < tags.height; ++y) {
        rows.advance(y);
        float* to = found.values.data() + y * width;
        if (decimal) {
            std::memcpy(to, rows.row(0), width * sizeof(float));
            continue;
        }
        std::memcpy(samples.data(), rows.row(0), width * sizeof(std::uint16_t));
        for (std::size_t x = 0; x < width; ++x)
            to[x] = static_cast<float>(white_is_zero ? 65535 - samples[x] : samples[x]) / 65535;
    }
    return found;
}

}  // namespace tactics
