// SPDX-License-Identifier: Apache-2.0
// Brings a picture down to the resolution of the page: what no finger can tell is not worked on.
#include <algorithm>
#include <cmath>

#include "tactics/filter.h"
#include "tactics/readers/shrink.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// 150 dpi: drawings made at 150 and at 300 dpi of the page agree to F 0.95-0.99 within 0.5 mm, and the coarser has fewer,
// longer lines; a fingertip tells about 25 dpi.
constexpr Option kResampleOptions[] = {
    {.name = "dpi",
     .type = Option::Type::number,
     .fallback = 150,
     .min = 25,
     .max = 1200,
     .unit = "dpi",
     .summary = "pixels per inch of the page; a picture that has fewer is unchanged"},
};

int resample_shrunk(int length, double scale) { return std::max(1, static_cast<int>(std::lround(length * scale))); }

Artwork apply_resample(Artwork artwork, const Settings& settings) {
    auto& image = std::get<Image>(artwork);
    const double scale = image.mm_per_pixel * settings.number("dpi") / kMmPerInch;
    const int longer = std::max(image.width, image.height);
    if (resample_shrunk(longer, scale) >= longer) return artwork;
    // The longer side keeps its length on the page exactly; the other one to half a pixel.
    const double mm_per_pixel = image.mm_per_pixel * longer / resample_shrunk(longer, scale);
    Image small{resample_shrunk(image.width, scale), resample_shrunk(image.height, scale), image.channels, mm_per_pixel, {}};
    RowShrinker<std::uint8_t> rows({image.width, image.height}, {small.width, small.height}, image.channels);
    for (int y = 0; y < image.height; ++y) rows.add(image.row(y));
    small.pixels = rows.take();
    return small;
}

// Nothing finer than the medium shows.
void fit_resample(Settings& settings, const Medium& medium) {
    if (settings.number("dpi") > medium.dpi) settings.set("dpi", to_text(medium.dpi), "resample", "resample");
}

}  // namespace

extern const Filter resample_filter;
const Filter resample_filter{
    .name = "resample",
    .summary = "shrinks the picture to the resolution of the page by averaging; never enlarges",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::picture),
    .options = kResampleOptions,
    .apply = apply_resample,
    .fit = fit_resample,
    .dpi = "dpi",
};

}  // namespace tactics
