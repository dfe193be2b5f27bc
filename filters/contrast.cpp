// SPDX-License-Identifier: Apache-2.0
// Stretches the greys of a faint or dark picture to full black and white.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "filters/histogram.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

constexpr Option kContrastOptions[] = {
    {.name = "black",
     .type = Option::Type::number,
     .fallback = 1,
     .min = 0,
     .max = 49,
     .unit = "%",
     .summary = "percentile of the pixels' greys that becomes full black"},
    {.name = "white",
     .type = Option::Type::number,
     .fallback = 99,
     .min = 51,
     .max = 100,
     .unit = "%",
     .summary = "percentile of the pixels' greys that becomes full white"},
    {.name = "gamma",
     .type = Option::Type::number,
     .fallback = 1,
     .min = 0.1,
     .max = 10,
     .summary = "over 1 brightens the middle greys, under 1 darkens them"},
};

Artwork apply_contrast(Artwork artwork, const Settings& settings) {
    auto& image = std::get<Image>(artwork);
    const auto counts = count_levels(image);
    const auto total = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
    // From one end of the greys: the first level at which more than the share of pixels has been passed.
    const auto first_over = [&](double share, int from, int step) {
        double seen = 0;
        int level = from;
        for (; level >= 0 && level < 256; level += step) {
            seen += static_cast<double>(counts[static_cast<std::size_t>(level)]);
            if (seen > total * share / 100) break;
        }
        return level;
    };
    const int black = first_over(settings.number("black"), 0, 1);
    const int white = first_over(100 - settings.number("white"), 255, -1);
    if (white <= black) return artwork;

    const double exponent = 1 / settings.number("gamma");
    std::array<std::uint8_t, 256> table{};
    for (int v = 0; v < 256; ++v) {
        const double share = std::clamp(static_cast<double>(v - black) / (white - black), 0.0, 1.0);
        table[static_cast<std::size_t>(v)] = static_cast<std::uint8_t>(std::lround(255 * std::pow(share, exponent)));
    }
    for (auto& sample : image.pixels) sample = table[sample];
    return artwork;
}

}  // namespace

extern const Filter contrast_filter;
const Filter contrast_filter{
    .name = "contrast",
    .summary = "stretches the greys to full black and white; a picture with a single grey is unchanged",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::picture),
    .options = kContrastOptions,
    .apply = apply_contrast,
};

}  // namespace tactics
