// Takes away what is too small to mean anything under a finger.
#include <algorithm>
#include <numbers>

#include "filters/components.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

constexpr Option kOptions[] = {
    {.name = "size",
     .type = Option::Type::length,
     .fallback = 2,
     .min = 0,
     .max = 50,
     .unit = "mm",
     .summary =
         "smaller specks than a disc of this diameter go, and shorter pieces of thinned edges; under 1 pixel it has no effect",
     .choices = {}},
};

// Sets every pixel of the pieces of fewer than `least` pixels to `blank`.
template <typename Value>
void remove_small(std::vector<Value>& values, int width, const Components& components, double least, Value blank) {
    const auto areas = components.areas();
    for (const Run& run : components.runs) {
        if (static_cast<double>(areas[run.component]) >= least) continue;
        const auto row = values.begin() + static_cast<std::ptrdiff_t>(run.row) * width;
        std::fill(row + run.begin, row + run.end, blank);
    }
}

Artwork apply(Artwork artwork, const Settings& settings) {
    const auto disc = [&](double mm_per_pixel) {
        const double diameter = settings.number("size") / mm_per_pixel;
        return std::numbers::pi / 4 * diameter * diameter;
    };
    if (auto* edges = std::get_if<EdgeMap>(&artwork)) {
        const double length = settings.number("size") / edges->mm_per_pixel;
        if (length < 1) return artwork;
        const auto pieces = find_components(edges->width, edges->height, Joined::by_corners,
                                            [&](std::size_t i) { return edges->strength[i] > 0; });
        remove_small(edges->strength, edges->width, pieces, edges->thinned ? length : disc(edges->mm_per_pixel), 0.0f);
        return artwork;
    }
    Image image = to_grey(std::move(std::get<Image>(artwork)));
    if (settings.number("size") < image.mm_per_pixel) return image;
    const auto specks =
        find_components(image.width, image.height, Joined::by_corners, [&](std::size_t i) { return image.pixels[i] < 128; });
    remove_small(image.pixels, image.width, specks, disc(image.mm_per_pixel), std::uint8_t{255});
    return image;
}

}  // namespace

extern const Filter despeckle_filter;
const Filter despeckle_filter{
    .name = "despeckle",
    .summary = "removes small specks of ink (darker than 128), or short pieces of edges",
    .takes = Kind::picture | Kind::edges,
    .gives = 0,
    .uses_colour = false,
    .options = kOptions,
    .apply = apply,
};

}  // namespace tactics
