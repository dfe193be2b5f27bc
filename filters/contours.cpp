// SPDX-License-Identifier: Apache-2.0
// Contours as a person would draw them, without training: colour counts as well as lightness, strength is collected along
// lines, texture is held down by the quieter of its two sides, and what mere noise would give is left out.
//
// Each part was kept because it raised agreement with human contours (F of the traced lines, one threshold for 50 photographs
// and as much on 50 others: tactics evaluate): colour in the structure tensor 0.58 -> 0.63, pooling along lines 0.64, tracing
// 0.65, the quieter side as surround 0.67. What keeps a drawing the same from copy to copy of a picture, colour at a wider
// scale and black, white and middle grey of its own, costs 0.005 of that, and so does what keeps walls blank. A second scale,
// signed instead of energy pooling, and histograms gave nothing more.
#include <algorithm>
#include <array>
#include <cmath>

#include "filters/contour_maps.h"
#include "filters/edge_map.h"
#include "filters/edge_noise.h"
#include "filters/map_choice.h"
#include "filters/plain_contours.h"
#include "filters/thick_lines.h"
#include "filters/thin_lines.h"
#include "tactics/filter.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr std::array kContoursOptions{
    Option{.name = "map",
           .type = Option::Type::choice,
           .fallback = 0,
           .min = 0,
           .max = 2,
           .summary = "plain: without training; learned: contours as people draw them, by a small net, which ignores the other "
                      "settings; auto: learned if its file is installed",
           .choices = "plain learned auto"},
    Option{.name = "blur",
           .type = Option::Type::length,
           .fallback = 1.1,
           .min = 0,
           .max = 20,
           .unit = "mm",
           .summary = "Gaussian blur applied first (standard deviation)"},
    Option{.name = "scene",
           .type = Option::Type::number,
           .fallback = 0,
           .min = 0,
           .max = 10,
           .unit = "%",
           .summary = "a wider blur for a large drawing, this share of its side: finer things are no main contours"},
    Option{.name = "chroma",
           .type = Option::Type::number,
           .fallback = 1.5,
           .min = 0,
           .max = 10,
           .summary = "how much a step in colour counts relative to one in lightness"},
    Option{.name = "along",
           .type = Option::Type::length,
           .fallback = 3.4,
           .min = 0,
           .max = 20,
           .unit = "mm",
           .summary = "length along lines over which strengths are summed (standard deviation)"},
    Option{.name = "surround",
           .type = Option::Type::number,
           .fallback = 1,
           .min = 0,
           .max = 3,
           .summary = "subtract this share of the mean strength beside a line, on its quieter side: suppresses texture"},
    Option{.name = "floor",
           .type = Option::Type::number,
           .fallback = kStaircase,
           .min = 0,
           .max = 255,
           .unit = "grey levels",
           .summary = "steps weaker than this are no contours, however faint the picture"},
    Option{.name = "lines",
           .type = Option::Type::length,
           .fallback = 0,
           .min = 0,
           .max = 5,
           .unit = "mm",
           .summary = "a thing no wider than this is a line, drawn by its middle, not by its two edges; 0: there are no lines"},
};

// Scans and prints bring a frame along: a line close beside the border says nothing of the scene, one that runs out of it does.
constexpr double kBorder = 2;            // in blurs
constexpr float kContoursBeside = 0.9f;  // cosine of the angle to the border, 26 degrees

void leave_the_border(EdgeMap& map, double sigma) {
    const int border = static_cast<int>(std::lround(kBorder * sigma));
    std::size_t i = 0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x, ++i) {
            const bool left_or_right = std::min(x, map.width - 1 - x) < border,
                       above_or_below = std::min(y, map.height - 1 - y) < border;
            if (map.strength[i] <= 0 || !(left_or_right || above_or_below)) continue;
            if ((left_or_right && std::abs(std::cos(map.normal[i])) > kContoursBeside) ||
                (above_or_below && std::abs(std::sin(map.normal[i])) > kContoursBeside))
                map.strength[i] = 0;
        }
}

// The two edges of what is narrower have no room beside each other: 3.2 mm of ground (filters/separate.cpp) and the lines
// themselves. What is wider may be a bar; if it is bent it is a line of a very broad pen.
constexpr double kNoRoom = 4.2, kWidestPen = 7;  // mm

// What is stronger is no noise, however much of it is taken off as texture, if half of that is left.
constexpr double kLeft = 0.5;

double blur_of(const Image& picture, const Settings& settings) {  // pixels
    const double side = std::sqrt(static_cast<double>(picture.width) * picture.height);
    return std::max({settings.number("blur") / picture.mm_per_pixel, settings.number("scene") / 100 * side, 0.5});
}

// Chances: what is hardly one goes, so that blank walls stay blank; noise needs no level of its own.
EdgeMap learned_contours(const Image& picture, const ContourNet& net) {
    constexpr float kHardly = 20;
    constexpr double kReach = 2;  // pixels to either side in which a contour's chance falls off
    EdgeMap thin = thin_edges(learned_map_of(picture, net), kReach);
    leave_the_border(thin, kReach);
    drop_below(thin, kHardly);
    thin.mm_per_pixel = picture.mm_per_pixel;
    return thin;
}

ChosenSetting settle_contours(const Artwork& artwork, Settings& settings) {
    if (ChosenSetting said = settle_map(settings, "contours"); !said.empty() || settings.choice("map") == "learned") return said;
    const Image& picture = std::get<Image>(artwork);
    const double pixels = blur_of(picture, settings), blur = pixels * picture.mm_per_pixel;
    const double scene = settings.number("scene") / 100 * std::sqrt(static_cast<double>(picture.width) * picture.height);
    if (pixels > scene || blur <= settings.number("blur")) return {};  // pixels themselves may be wider than either
    return {"scene=" + to_text(settings.number("scene")),
            phrase("what is finer than {0} mm, that many percent of the side of this drawing, is left out",
                   numeral(std::round(blur * 10) / 10))};
}

Artwork apply_contours(Artwork artwork, const Settings& settings) {
    const Image& picture = std::get<Image>(artwork);
    const double mm = picture.mm_per_pixel;
    if (const auto net = net_for(settings)) return learned_contours(picture, *net);
    const double sigma = blur_of(picture, settings);
    const PlainMap map = plain_contours(picture, {.blur = sigma,
                                                  .along = settings.number("along") / mm,
                                                  .chroma = settings.number("chroma"),
                                                  .surround = settings.number("surround"),
                                                  .floor = settings.number("floor")});
    if (map.edges.thinned) return map.edges;
    EdgeMap thin = thin_edges(map.edges, sigma);
    leave_the_border(thin, sigma);
    drop_below(thin, static_cast<float>(kLeft * map.noise));
    // The edges beside a line stand a blur away from it, and no more than half of one farther.
    const double lines = settings.number("lines") / mm;
    add_thin_lines(thin, picture, lines, 1.5 * sigma);
    if (lines > 0) {
        // What is narrower is a thin line. Of three pixels that are as coarse as the blur both edges are one.
        const double narrowest = 2 * std::ceil(lines / 2) + (lines <= 2 ? 1.5 : 0.5);
        add_thick_lines(thin, picture, {narrowest, kNoRoom / mm, false}, 1.5 * sigma);
        add_thick_lines(thin, picture, {std::max(narrowest, kNoRoom / mm), kWidestPen / mm, true}, 1.5 * sigma);
    }
    return thin;
}

}  // namespace

extern const Filter contours_filter;
const Filter contours_filter{
    .name = "contours",
    .summary = "contours of a photograph: uses colour, sums strengths along lines, suppresses texture",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::edges),
    .uses_colour = true,
    .options = kContoursOptions,
    .apply = apply_contours,
    .settle = settle_contours,
    .in_full = "contours scene=0",
};

}  // namespace tactics
