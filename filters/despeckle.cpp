// SPDX-License-Identifier: Apache-2.0
// Takes away what is too small to mean anything under a finger.
#include <algorithm>
#include <numbers>

#include "filters/components.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

constexpr Option kDespeckleOptions[] = {
    {.name = "size",
     .type = Option::Type::length,
     .fallback = 2,
     .min = 0,
     .max = 50,
     .unit = "mm",
     .summary = "remove specks smaller than a disc of this diameter, and pieces of edges shorter than it; no effect under 1 "
                "pixel"},
};

// Sets every pixel of the pieces whose size is under `least` to `blank`.
template <typename Value>
void remove_small(std::vector<Value>& values, int width, const Components& pieces, const std::vector<std::size_t>& sizes,
                  double least, Value blank) {
    for (const Run& run : pieces.runs) {
        if (static_cast<double>(sizes[run.component]) >= least) continue;
        const auto row = values.begin() + static_cast<std::ptrdiff_t>(run.row) * width;
        std::fill(row + run.begin, row + run.end, blank);
    }
}

Artwork apply_despeckle(Artwork artwork, const Settings& settings) {
    if (auto* edges = std::get_if<EdgeMap>(&artwork)) {
        const double size = settings.number("size") / edges->mm_per_pixel;
        if (size < 1) return artwork;
        const auto pieces = find_components(edges->width, edges->height, Joined::by_corners,
                                            [&](std::size_t i) { return edges->strength[i] > 0; });
        // Not by its length: the outline of a letter is long.
        remove_small(edges->strength, edges->width, pieces, pieces.extents(), size, 0.0f);
        return artwork;
    }
    Image image = to_grey(std::move(std::get<Image>(artwork)));
    const double diameter = settings.number("size") / image.mm_per_pixel;
    if (diameter < 1) return image;
    const auto specks =
        find_components(image.width, image.height, Joined::by_corners, [&](std::size_t i) { return image.pixels[i] < 128; });
    remove_small(image.pixels, image.width, specks, specks.areas(), std::numbers::pi / 4 * diameter * diameter,
                 std::uint8_t{255});
    return image;
}

}  // namespace

extern const Filter despeckle_filter;
const Filter despeckle_filter{
    .name = "despeckle",
    .summary = "removes small specks of ink (darker than 128) or short pieces of edges",
    .takes = Kind::picture | Kind::edges,
    .options = kDespeckleOptions,
    .apply = apply_despeckle,
};

}  // namespace tactics
