// SPDX-License-Identifier: Apache-2.0
// Decides what is ink and what is ground, or which edges stay.
#include <algorithm>
#include <cmath>

#include "filters/components.h"
#include "filters/edge_map.h"
#include "filters/edge_noise.h"
#include "filters/kmeans_exact.h"
#include "filters/opencv.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

constexpr Option kThresholdOptions[] = {
    {.name = "method",
     .type = Option::Type::choice,
     .fallback = 1,
     .min = 0,
     .max = 3,
     .summary = "otsu finds the level that best separates light from dark, adaptive a level for each place (for uneven light), "
                "hysteresis keeps weak parts connected to strong ones",
     .choices = "fixed otsu adaptive hysteresis"},
    {.name = "level",
     .type = Option::Type::number,
     .fallback = 128,
     .min = 0,
     .max = 255,
     .unit = "grey levels",
     .summary = "fixed: darker pixels become ink; weaker edges are dropped"},
    {.name = "low",
     .type = Option::Type::number,
     .fallback = 20,
     .min = 0,
     .max = 255,
     .unit = "grey levels",
     .summary = "hysteresis: darker pixels are ink; weaker edges are dropped"},
    {.name = "high",
     .type = Option::Type::number,
     .fallback = 60,
     .min = 0,
     .max = 255,
     .unit = "grey levels",
     .summary = "hysteresis: darker pixels are ink if they touch ink; edges this strong are kept, with everything connected to "
                "them"},
    {.name = "window",
     .type = Option::Type::length,
     .fallback = 8,
     .min = 0,
     .max = 100,
     .unit = "mm",
     .summary = "adaptive: side of the square whose mean is the level; no effect under 1 pixel"},
    {.name = "offset",
     .type = Option::Type::number,
     .fallback = 8,
     .min = 0,
     .max = 255,
     .unit = "grey levels",
     .summary = "adaptive: how much darker than the mean ink must be, or how much stronger an edge"},
};

// Otsu's level is the best cut into two classes, so it is exact k-means with k = 2. Index of the first level above it.
std::size_t otsu(std::span<const Level> levels, std::size_t fallback) {
    const Classes classes = kmeans_exact(levels, 2);
    return classes.first.size() == 2 ? classes.first[1] : fallback;
}

// Mean of the square around every pixel; the edge pixels go on beyond the picture.
cv::Mat local_mean(const cv::Mat& values, double window) {
    // Twice the picture is as good as any wider window.
    const double widest = 2.0 * std::max(values.cols, values.rows);
    const int side = 2 * static_cast<int>(std::min(window, widest) / 2) + 1;
    cv::Mat mean;
    cv::boxFilter(values, mean, CV_32F, cv::Size(side, side), cv::Point(-1, -1), true, cv::BORDER_REPLICATE);
    return mean;
}

Image cut_hysteresis(Image image, double low, double high) {
    const auto runs = connected_to(
        image.width, image.height, [&](std::size_t i) { return image.pixels[i] < low; },
        [&](std::size_t i) { return image.pixels[i] < high; });
    std::fill(image.pixels.begin(), image.pixels.end(), std::uint8_t{255});
    for (const Run& run : runs) std::fill(image.row(run.row) + run.begin, image.row(run.row) + run.end, std::uint8_t{0});
    return image;
}

Image cut_adaptive(Image image, double window, double offset) {
    if (window < 1) return image;
    const cv::Mat mean = local_mean(view_of(std::as_const(image)), window);
    const auto below = static_cast<float>(offset);
    for (int y = 0; y < image.height; ++y) {
        const auto* means = mean.ptr<float>(y);
        auto* row = image.row(y);
        for (int x = 0; x < image.width; ++x) row[x] = static_cast<float>(row[x]) < means[x] - below ? 0 : 255;
    }
    return image;
}

Image cut_picture(Image image, const Settings& settings) {
    const auto method = settings.choice("method");
    const double low = std::min(settings.number("low"), settings.number("high"));
    const double high = std::max(settings.number("low"), settings.number("high"));
    if (method == "hysteresis") return cut_hysteresis(std::move(image), low, high);
    if (method == "adaptive") {
        const double window = settings.number("window") / image.mm_per_pixel;
        return cut_adaptive(std::move(image), window, settings.number("offset"));
    }
    // A picture of one grey has no best level: dark is ink, light is ground.
    const double level = method == "fixed" ? settings.number("level") : static_cast<double>(otsu(levels_of(image), 128));
    const auto first_ground = static_cast<int>(std::ceil(level));
    for (auto& sample : image.pixels) sample = sample < first_ground ? 0 : 255;
    return image;
}

// The methods that follow the picture's own contrast would draw the noise of an empty one; the noise floor forbids it.
EdgeMap cut_edges(EdgeMap edges, const Settings& settings) {
    const auto method = settings.choice("method");
    auto& strength = edges.strength;
    if (method == "hysteresis") {
        const auto low = static_cast<float>(std::min(settings.number("low"), settings.number("high")));
        const auto high = static_cast<float>(std::max(settings.number("low"), settings.number("high")));
        return keep_connected(std::move(edges), low, high);
    }
    if (method == "fixed") {
        drop_below(edges, static_cast<float>(settings.number("level")));
        return edges;
    }
    const float floor = noise_floor(edges);
    if (method == "otsu") {
        const StrengthHistogram histogram(strength, edges.thinned);
        drop_below(edges, std::max(floor, histogram.least_of(otsu(histogram.levels(), 0))));
        return edges;
    }
    const double window = settings.number("window") / edges.mm_per_pixel;
    if (window < 1) return edges;
    const cv::Mat mean = local_mean(view_of(std::as_const(edges)), window);
    const auto offset = static_cast<float>(settings.number("offset"));
    const float* means = mean.ptr<float>();
    for (std::size_t i = 0; i < strength.size(); ++i)
        if (strength[i] < floor || strength[i] < means[i] + offset) strength[i] = 0;
    return edges;
}

Artwork apply_threshold(Artwork artwork, const Settings& settings) {
    if (auto* edges = std::get_if<EdgeMap>(&artwork)) return cut_edges(std::move(*edges), settings);
    return cut_picture(to_grey(std::move(std::get<Image>(artwork))), settings);
}

}  // namespace

extern const Filter threshold_filter;
const Filter threshold_filter{
    .name = "threshold",
    .summary = "makes a picture black and white, or drops weak edges",
    .takes = Kind::picture | Kind::edges,
    .options = kThresholdOptions,
    .apply = apply_threshold,
    .finishes = static_cast<Kinds>(Kind::edges),
    .cuts_edges = true,
};

}  // namespace tactics
