// SPDX-License-Identifier: Apache-2.0
// Heights, or the raised lines of a page, as a solid for 3-D printers and mills: on a plate.
#include "print/format.h"
#include "print/page_relief.h"

namespace tactics {

namespace {

// A nozzle of 0.4 mm prints no finer, and A4 at 0.1 mm could be 12 million triangles.
constexpr Option coarser(Option pitch) {
    pitch.fallback = 0.25;
    return pitch;
}

constexpr Option kStlOptions[] = {
    coarser(kReliefPitch), kReliefHeight, kReliefProfile, kReliefAxes, kReliefGrid, kPlateBase,
};

std::string encode_stl(const HeightSheet& sheet, const HeightRows& rows, const Settings& settings) {
    return height_stl(sheet, rows, settings.number("base"), "stl");
}

}  // namespace

extern const Format stl_format;
const Format stl_format{
    .name = "stl",
    .summary = "raised lines on a plate as a closed solid (binary STL, mm), for 3-D printers",
    .extensions = "stl",
    .medium = "swell",
    .paper = "a4",
    .options = kStlOptions,
    .encode_heights = encode_stl,
};

}  // namespace tactics
