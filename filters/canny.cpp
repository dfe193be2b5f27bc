// SPDX-License-Identifier: Apache-2.0
// J. Canny, A Computational Approach to Edge Detection, IEEE PAMI 8(6), 1986: blur, gradient, thin, hysteresis.
#include <algorithm>
#include <array>

#include "filters/edge_map.h"
#include "filters/edge_noise.h"
#include "filters/gradient.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

constexpr std::array kCannyOptions{
    Option{.name = "blur",
           .type = Option::Type::length,
           .fallback = 1.2,
           .min = 0,
           .max = 20,
           .unit = "mm",
           .summary = "Gaussian blur applied first (standard deviation)"},
    Option{.name = "high",
           .type = Option::Type::number,
           .fallback = 48,
           .min = 0,
           .max = 255,
           .unit = "grey levels",
           .summary = "an edge must reach this strength somewhere"},
    Option{.name = "low",
           .type = Option::Type::number,
           .fallback = 24,
           .min = 0,
           .max = 255,
           .unit = "grey levels",
           .summary = "and this strength everywhere (never more than high)"},
};

Artwork apply_canny(Artwork artwork, const Settings& settings) {
    const Image grey = to_grey(std::get<Image>(std::move(artwork)));
    const double sigma = settings.number("blur") / grey.mm_per_pixel;
    const GradientTensor tensor = gradient_tensor(grey_plane(grey), sigma);
    const auto high = static_cast<float>(settings.number("high"));
    const auto low = std::min(static_cast<float>(settings.number("low")), high);
    EdgeMap map = strongest_direction(tensor, 0, grey.mm_per_pixel);
    map.noise = static_cast<float>(noise_scale(noise_level(grey), sigma));
    return keep_connected(thin_edges(map, sigma), low, high);
}

}  // namespace

extern const Filter canny_filter;
const Filter canny_filter{
    .name = "canny",
    .summary = "thin edges by Canny's method with fixed thresholds",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::edges),
    .options = kCannyOptions,
    .apply = apply_canny,
};

}  // namespace tactics
