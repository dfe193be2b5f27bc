// SPDX-License-Identifier: Apache-2.0
// Pictures to try filters on, and the short way to run one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

#include "filters/list.h"
#include "tactics/recipe.h"

namespace tactics::pictures {

inline constexpr double kPixel = 0.25;  // mm, so that 1 mm is 4 pixels

/// A filter as a recipe spells it: "threshold method=fixed level=100".
inline Artwork filtered(std::string_view line, Artwork artwork) {
    const Step step = parse_step(line, "test", filters());
    return step.filter->apply(std::move(artwork), step.settings);
}
inline Image filtered_image(std::string_view line, const Image& image) { return std::get<Image>(filtered(line, image)); }
inline EdgeMap filtered_edges(std::string_view line, const EdgeMap& edges) { return std::get<EdgeMap>(filtered(line, edges)); }

/// Random numbers that are the same everywhere (splitmix64).
class Chance {
public:
    explicit Chance(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    int below(int limit) { return static_cast<int>(next() % static_cast<std::uint64_t>(limit)); }
    double unit() { return (static_cast<double>(next() >> 11) + 0.5) / 9007199254740992.0; }
    double normal() { return std::sqrt(-2 * std::log(unit())) * std::cos(2 * std::numbers::pi * unit()); }

private:
    std::uint64_t state_;
};

/// A picture of `level(x, y)`, rounded and held within 0-255.
template <typename LevelAt>
Image drawn(int width, int height, LevelAt level) {
    Image image = make_image(width, height, 1, kPixel, 0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.row(y)[x] = static_cast<std::uint8_t>(std::clamp(std::lround(static_cast<double>(level(x, y))), 0l, 255l));
    return image;
}

inline Image random_grey(int width, int height, std::uint64_t seed) {
    Chance chance(seed);
    return drawn(width, height, [&](int, int) { return chance.below(256); });
}

/// Leaves on leaves, of which none is more than another.
inline Image leaves() {
    Chance chance(7);
    Image image = make_image(480, 320, 1, kPixel, 0);
    for (int i = 0; i < 6000; ++i) {
        const int x = chance.below(480), y = chance.below(320), r = 6 + chance.below(14), grey = 60 + chance.below(120);
        for (int v = std::max(0, y - r); v < std::min(320, y + r); ++v)
            for (int u = std::max(0, x - r); u < std::min(480, x + r); ++u)
                if (std::hypot(u - x, v - y) < r) image.row(v)[u] = static_cast<std::uint8_t>(grey);
    }
    return image;
}

/// Blobs of ink and ground of all sizes, 0 and 255 only.
inline Image random_ink(int width, int height, std::uint64_t seed, int percent = 50) {
    Chance chance(seed);
    return drawn(width, height, [&](int, int) { return chance.below(100) < percent ? 0 : 255; });
}

inline Image random_colour(int width, int height, std::uint64_t seed) {
    Chance chance(seed);
    Image image = make_image(width, height, 3, kPixel, 0);
    for (auto& sample : image.pixels) sample = static_cast<std::uint8_t>(chance.below(256));
    return image;
}

/// Strengths of a plain edge detector: Gaussian of `sigma` pixels, central differences, scaled so that a straight step of
/// h grey levels gives h. The picture must be larger than the blur.
template <typename LevelAt>
EdgeMap edges_of(int width, int height, double sigma, LevelAt level) {
    const int reach = static_cast<int>(std::ceil(4 * sigma));
    std::vector<double> kernel;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i) sum += kernel.emplace_back(std::exp(-i * i / (2 * sigma * sigma)));
    // Mirrored at the border, the outermost pixel not repeated.
    const auto mirrored = [](int i, int length) {
        return static_cast<std::size_t>(i < 0 ? -i : i >= length ? 2 * length - 2 - i : i);
    };
    const auto at = [&](const std::vector<double>& values, int x, int y) {
        return values[mirrored(y, height) * static_cast<std::size_t>(width) + mirrored(x, width)];
    };
    const auto filled = [&](auto value) {
        std::vector<double> values;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) values.push_back(value(x, y));
        return values;
    };
    const auto blurred = [&](const std::vector<double>& values, int dx, int dy) {
        return filled([&](int x, int y) {
            double total = 0;
            for (int i = -reach; i <= reach; ++i)
                total += kernel[static_cast<std::size_t>(i + reach)] / sum * at(values, x + i * dx, y + i * dy);
            return total;
        });
    };
    const auto smooth =
        blurred(blurred(filled([&](int x, int y) { return std::round(std::clamp<double>(level(x, y), 0, 255)); }), 1, 0), 0, 1);
    const double step_gradient = 1 / (sigma * std::sqrt(2 * std::numbers::pi));
    EdgeMap edges;
    edges.width = width;
    edges.height = height;
    edges.mm_per_pixel = kPixel;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            edges.strength.push_back(static_cast<float>(
                std::hypot(at(smooth, x + 1, y) - at(smooth, x - 1, y), at(smooth, x, y + 1) - at(smooth, x, y - 1)) / 2 /
                step_gradient));
    return edges;
}

inline std::size_t count_set(const EdgeMap& edges) {
    return edges.strength.size() - static_cast<std::size_t>(std::count(edges.strength.begin(), edges.strength.end(), 0.0f));
}
inline std::size_t count_level(const Image& image, int level) {
    return static_cast<std::size_t>(std::count(image.pixels.begin(), image.pixels.end(), static_cast<std::uint8_t>(level)));
}

}  // namespace tactics::pictures
