// SPDX-License-Identifier: Apache-2.0
// A picture of heights for milling, 3-D printing and haptic devices: grey, lines raised from a flat ground, as 16-bit PNG, as
// TIFF, as EXR and packed.
//
// A sample is the height at the centre of its pixel: 0 (black) is the ground, 65535 (white) the full height; floating-point
// numbers are mm. The file states the scale: its resolution, and the entries of tactics/relief/height_words.h.
#include "print/format.h"
#include "print/page_relief.h"

namespace tactics {

namespace {

constexpr Option kHeightmapOptions[] = {kReliefPitch, kReliefHeight, kReliefProfile, kReliefAxes, kReliefGrid};

constexpr Option kHeightmapTiffOptions[] = {
    kReliefPitch,
    kReliefHeight,
    kReliefProfile,
    kReliefAxes,
    kReliefGrid,
    {.name = "samples",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "16: whole numbers, black to white; decimal: 32-bit numbers, mm",
     .choices = "16 decimal"},
};

std::string encode_png(const HeightSheet& sheet, const HeightRows& rows, const Settings&) { return height_png(sheet, rows); }

std::string encode_tiff(const HeightSheet& sheet, const HeightRows& rows, const Settings& settings) {
    return (settings.choice("samples") == "decimal" ? height_tiff_decimal : height_tiff)(sheet, rows);
}

std::string encode_exr(const HeightSheet& sheet, const HeightRows& rows, const Settings&) { return height_exr(sheet, rows); }

std::string encode_felt(const HeightSheet& sheet, const HeightRows& rows, const Settings&) { return height_felt(sheet, rows); }

}  // namespace

extern const Format heightmap_format;
const Format heightmap_format{
    .name = "heightmap",
    .summary = "heights as a 16-bit grey PNG, for milling and haptic devices",
    .extensions = "height.png",
    .medium = "swell",
    .paper = "a4",
    .options = kHeightmapOptions,
    .encode_heights = encode_png,
};

extern const Format heightmap_tiff_format;
const Format heightmap_tiff_format{
    .name = "heightmap-tiff",
    .summary = "the same heights as TIFF, 16-bit or floating-point",
    .extensions = "height.tiff height.tif",
    .medium = "swell",
    .paper = "a4",
    .options = kHeightmapTiffOptions,
    .encode_heights = encode_tiff,
};

extern const Format heightmap_exr_format;
const Format heightmap_exr_format{
    .name = "heightmap-exr",
    .summary = "the same heights as OpenEXR, 32-bit floating-point numbers in mm",
    .extensions = "height.exr",
    .medium = "swell",
    .paper = "a4",
    .options = kHeightmapOptions,
    .encode_heights = encode_exr,
};

extern const Format felt_format;
const Format felt_format{
    .name = "felt",
    .summary = "the same heights packed without loss; any part can be read alone (tactics help felt)",
    .extensions = "height.felt felt",
    .medium = "swell",
    .paper = "a4",
    .options = kHeightmapOptions,
    .encode_heights = encode_felt,
};

}  // namespace tactics
