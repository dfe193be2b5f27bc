// SPDX-License-Identifier: Apache-2.0
// Cuts the greys, the colours or the strengths of edges into a few classes.
//
// On a picture it makes regions of one grey. On an edge map it is a threshold that follows the picture's own contrast: a
// fixed one loses a dark or faint picture, this one draws it like a bright one (measured: 0.97 of the drawing stays at a
// tenth of the brightness, against 0). Its danger, drawing the grain of an empty picture, is met by a floor.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "filters/edge_noise.h"
#include "filters/kmeans_colour.h"
#include "filters/kmeans_exact.h"
#include "filters/kmeans_iterative.h"
#include "filters/lab.h"
#include "filters/level_choice.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

constexpr Option kKmeansOptions[] = {
    {.name = "k",
     .type = Option::Type::whole,
     .fallback = 4,
     .min = 0,
     .max = 16,
     .unit = "classes",
     .summary = "number of classes, or of greys if there are fewer; 0: as few as the picture needs, at most 5"},
    {.name = "method",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "exact finds the optimum; iterative improves a random start, for comparison",
     .choices = "exact iterative"},
    {.name = "colour",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "yes: classes of colour as the eye distinguishes them, without randomness; no: classes of grey",
     .choices = "no yes"},
    {.name = "seed",
     .type = Option::Type::whole,
     .fallback = 1,
     .min = 1,
     .max = 1'000'000,
     .summary = "iterative only: seed of the random start"},
    {.name = "keep",
     .type = Option::Type::whole,
     .fallback = 2,
     .min = 1,
     .max = 16,
     .unit = "classes",
     .summary = "edge maps only: number of the strongest classes to keep"},
    {.name = "floor",
     .type = Option::Type::number,
     .fallback = kStaircase,
     .min = 0,
     .max = 255,
     .unit = "grey levels",
     .summary = "edge maps only: weaker edges are never kept, nor those that the map's own noise can cause"},
};

// As it is usually described. More starts would hide what the exact one is compared with: that it hangs on them.
constexpr int kStarts = 1;

// Classes of the nearest centre, on the same levels as the exact ones.
Classes classes_around(const std::vector<double>& centres, std::span<const Level> levels) {
    Classes classes;
    std::size_t last = centres.size();
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (levels[i].weight <= 0) continue;
        std::size_t nearest = 0;
        for (std::size_t c = 1; c < centres.size(); ++c)
            if (std::abs(levels[i].value - centres[c]) < std::abs(levels[i].value - centres[nearest])) nearest = c;
        if (nearest != last) {
            classes.first.push_back(i);
            classes.centres.push_back(centres[nearest]);
            last = nearest;
        }
    }
    return classes;
}

// Variance that the best classes of those levels leave.
double unexplained(std::span<const Level> levels, int k) {
    double weight = 0;
    for (const Level& level : levels) weight += level.weight;
    return weight > 0 ? kmeans_exact(levels, k).squares / weight : 0;
}

// Of colours, in the lightness and colour of CIELAB.
double unexplained(const Image& image, const std::vector<std::vector<float>>& planes, int k) {
    const std::vector<std::vector<float>> classes = lab_planes(kmeans_colour(image, k));
    double squares = 0;
    for (std::size_t a = 0; a < planes.size(); ++a)
        for (std::size_t i = 0; i < planes[a].size(); ++i)
            squares += (static_cast<double>(planes[a][i]) - static_cast<double>(classes[a][i])) *
                       (static_cast<double>(planes[a][i]) - static_cast<double>(classes[a][i]));
    return squares / static_cast<double>(planes[0].size());
}

LevelChoice choose_k(const Artwork& artwork, const Settings& settings) {
    if (const auto* edges = std::get_if<EdgeMap>(&artwork)) {
        const StrengthHistogram histogram(edges->strength, edges->thinned);
        return choose_levels([&](int k) { return unexplained(histogram.levels(), k); }, 0,
                             std::clamp(settings.whole("keep") + 1, 2, 16));
    }
    const auto& image = std::get<Image>(artwork);
    const double noise = noise_level(to_grey(image)), variance = noise * noise;
    if (image.channels == 3 && settings.choice("colour") == "yes") {
        const auto planes = lab_planes(image);
        constexpr double kLabOfLevel = 100.0 / 255;
        return choose_levels([&](int k) { return unexplained(image, planes, k); }, variance * kLabOfLevel * kLabOfLevel, 1);
    }
    const std::vector<Level> levels = levels_of(image);
    return choose_levels([&](int k) { return unexplained(levels, k); }, variance, 1);
}

ChosenSetting settle_kmeans(const Artwork& artwork, Settings& settings) {
    if (settings.whole("k") > 0) return {};
    const LevelChoice choice = choose_k(artwork, settings);
    settings.set("k", std::to_string(choice.k), "kmeans", "kmeans");
    return {"k=" + std::to_string(choice.k), reason_of(choice, settings.choice("colour") == "yes")};
}

Classes solve(std::span<const Level> levels, const Settings& settings, auto samples) {
    const int k = settings.whole("k");
    if (settings.choice("method") == "exact") return kmeans_exact(levels, k);
    return classes_around(kmeans_iterative(samples(), k, kStarts, static_cast<std::uint64_t>(settings.whole("seed"))), levels);
}

Image cut_greys(Image image, const Settings& settings) {
    const std::vector<Level> levels = levels_of(image);
    const Classes classes = solve(levels, settings, [&] { return std::vector<float>(image.pixels.begin(), image.pixels.end()); });
    std::array<std::uint8_t, 256> table{};
    for (std::size_t v = 0; v < table.size(); ++v)
        table[v] = static_cast<std::uint8_t>(std::lround(classes.centres[classes.class_of(v)]));
    for (auto& sample : image.pixels) sample = table[sample];
    return image;
}

EdgeMap keep_strongest(EdgeMap edges, const Settings& settings) {
    for (float& s : edges.strength) s = s > 0 && s <= std::numeric_limits<float>::max() ? s : 0;  // drops NaN and infinity too
    // Of a thinned map only the ridges are asked: the pixels between them say how thin it is, not how strong.
    const StrengthHistogram histogram(edges.strength, edges.thinned);
    const Classes classes = solve(histogram.levels(), settings, [&] {
        std::vector<float> samples = edges.strength;
        if (edges.thinned) std::erase(samples, 0.0f);
        return samples;
    });
    if (classes.first.empty()) return edges;
    const std::size_t keep = std::min(static_cast<std::size_t>(settings.whole("keep")), classes.first.size());
    const std::size_t first = classes.first[classes.first.size() - keep];
    drop_below(edges, std::max(histogram.least_of(first), noise_floor(edges, static_cast<float>(settings.number("floor")))));
    return edges;
}

Artwork apply_kmeans(Artwork artwork, const Settings& given) {
    Settings settings = given;
    settle_kmeans(artwork, settings);
    if (auto* edges = std::get_if<EdgeMap>(&artwork)) return keep_strongest(std::move(*edges), settings);
    auto& image = std::get<Image>(artwork);
    if (image.channels == 3 && settings.choice("colour") == "yes") return kmeans_colour(std::move(image), settings.whole("k"));
    return cut_greys(to_grey(std::move(image)), settings);
}

}  // namespace

extern const Filter kmeans_filter;
const Filter kmeans_filter{
    .name = "kmeans",
    .summary = "sorts greys, colours or strengths of edges into a few classes; of edges, keeps the strongest classes",
    .takes = Kind::picture | Kind::edges,
    .uses_colour = true,
    .options = kKmeansOptions,
    .apply = apply_kmeans,
    .settle = settle_kmeans,
    .cuts_edges = true,
};

}  // namespace tactics
