// SPDX-License-Identifier: Apache-2.0
// Fills what is too small to be felt as a hole.
#include <algorithm>
#include <numbers>

#include "filters/components.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

constexpr Option kFillHolesOptions[] = {
    {.name = "size",
     .type = Option::Type::length,
     .fallback = 2,
     .min = 0,
     .max = 50,
     .unit = "mm",
     .summary = "fill holes smaller than a disc of this diameter; no effect under 1 pixel"},
};

Artwork apply_fill_holes(Artwork artwork, const Settings& settings) {
    Image image = to_grey(std::move(std::get<Image>(artwork)));
    const double diameter = settings.number("size") / image.mm_per_pixel;
    if (diameter < 1) return image;
    const Components ground =
        find_components(image.width, image.height, Joined::by_sides, [&](std::size_t i) { return image.pixels[i] >= 128; });
    // What reaches the edge of the picture is not shut in by ink: it may go on beyond.
    std::vector<bool> open(ground.count, false);
    for (const Run& run : ground.runs)
        if (run.row == 0 || run.row == image.height - 1 || run.begin == 0 || run.end == image.width) open[run.component] = true;
    const auto areas = ground.areas();
    const double least = std::numbers::pi / 4 * diameter * diameter;
    for (const Run& run : ground.runs)
        if (!open[run.component] && static_cast<double>(areas[run.component]) < least)
            std::fill(image.row(run.row) + run.begin, image.row(run.row) + run.end, std::uint8_t{0});
    return image;
}

}  // namespace

extern const Filter fill_holes_filter;
const Filter fill_holes_filter{
    .name = "fill-holes",
    .summary = "fills small white holes (128 or lighter) enclosed by ink",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::picture),
    .options = kFillHolesOptions,
    .apply = apply_fill_holes,
};

}  // namespace tactics
