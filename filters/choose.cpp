#include "filters/choose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "filters/edge_noise.h"

namespace tactics {

namespace {

// Drawn pictures have large parts of one colour, and between them steps; photographs have neither. The limits below
// stand in the middle of the wide gap between the two on a log scale and are not fitted to single pictures.
constexpr double kDrawnFew = 0.80;       // share of the eight commonest colours above which a picture was drawn
constexpr double kDrawnFlat = 0.55;      // and the share of flat places
constexpr double kTwoTone = 0.93;
constexpr double kInkOnPaper = 0.5;      // a silhouette has two tones, too, but no paper
constexpr double kPaper = 0.55;          // share of the ground in charts; maps are coloured all over
constexpr double kMapColour = 0.2;       // and a glaring photograph, white and black, is neither

int spread_of_neighbours(const Image& grey, int x, int y) {
    int low = 255, high = 0;
    for (int dy = -1; dy <= 1; ++dy) {
        const std::uint8_t* row = grey.row(y + dy) + x;
        low = std::min({low, static_cast<int>(row[-1]), static_cast<int>(row[0]), static_cast<int>(row[1])});
        high = std::max({high, static_cast<int>(row[-1]), static_cast<int>(row[0]), static_cast<int>(row[1])});
    }
    return high - low;
}

// A scan's grain or a camera's noise; more than this is texture.
double level_noise(const Image& grey) { return std::min(noise_level(grey), 4.0); }

// Share of the pixels in the eight highest peaks of the histogram, each as wide as one colour with that noise.
double share_in_peaks(std::array<std::size_t, 256> levels, std::size_t count, double noise) {
    const int reach = 1 + static_cast<int>(std::lround(noise));
    std::size_t sum = 0;
    for (int peak = 0; peak < 8; ++peak) {
        std::size_t best = 0;
        int best_level = 0;
        const auto window = [&](int level) {
            std::size_t in = 0;
            for (int i = std::max(level - reach, 0); i <= std::min(level + reach, 255); ++i) in += levels[static_cast<std::size_t>(i)];
            return in;
        };
        for (int level = 0; level < 256; ++level)
            if (const std::size_t in = window(level); in > best) best = in, best_level = level;
        sum += best;
        for (int i = std::max(best_level - reach, 0); i <= std::min(best_level + reach, 255); ++i) levels[static_cast<std::size_t>(i)] = 0;
    }
    return static_cast<double>(sum) / static_cast<double>(count);
}

double share_flat(const Image& grey) {
    if (grey.width < 3 || grey.height < 3) return 1;
    // The range of nine samples of noise is about three deviations; two levels are lost to rounding and compression.
    const int limit = 2 + static_cast<int>(std::lround(3 * level_noise(grey)));
    std::size_t flat = 0, count = 0;
    for (int y = 1; y + 1 < grey.height; y += 2)
        for (int x = 1; x + 1 < grey.width; x += 2, ++count)
            if (spread_of_neighbours(grey, x, y) <= limit) ++flat;
    return static_cast<double>(flat) / static_cast<double>(count);
}

double share_two_tone(const std::array<std::size_t, 256>& levels, std::size_t count) {
    const auto percentile = [&](double share) {
        std::size_t below = 0;
        int level = 0;
        while (level < 255 && static_cast<double>(below += levels[static_cast<std::size_t>(level)]) < share * static_cast<double>(count)) ++level;
        return level;
    };
    const int dark = percentile(0.002), bright = percentile(0.998);
    const int reach = (bright - dark) / 5;
    if (bright - dark < 64) return 0;  // too faint to be ink on paper
    std::size_t near = 0;
    for (int level = 0; level < 256; ++level)
        if (level <= dark + reach || level >= bright - reach) near += levels[static_cast<std::size_t>(level)];
    return static_cast<double>(near) / static_cast<double>(count);
}

std::string percent(double share) { return std::to_string(static_cast<int>(std::lround(100 * share))) + " %"; }

}  // namespace

Traits traits_of(const Image& picture) {
    Traits traits;
    const std::size_t count = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    const Image grey = to_grey(picture);
    std::array<std::size_t, 256> levels{};
    for (const std::uint8_t level : grey.pixels) ++levels[level];
    for (const std::size_t n : levels)
        if (n * 5000 > count) ++traits.greys;
    std::vector<std::size_t> colours(4096);
    std::size_t colourful = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* p = &picture.pixels[i * static_cast<std::size_t>(picture.channels)];
        const std::uint8_t r = p[0], g = picture.channels == 3 ? p[1] : r, b = picture.channels == 3 ? p[2] : r;
        ++colours[static_cast<std::size_t>((r >> 4) << 8 | (g >> 4) << 4 | b >> 4)];
        if (std::max({r, g, b}) - std::min({r, g, b}) > 24) ++colourful;
    }
    const auto share = [&](std::size_t n) { return static_cast<double>(n) / static_cast<double>(count); };
    traits.paper = share(*std::max_element(colours.begin(), colours.end()));
    traits.few = share_in_peaks(levels, count, level_noise(grey));
    traits.colourful = share(colourful);
    traits.flat = share_flat(grey);
    traits.two_tone = share_two_tone(levels, count);
    return traits;
}

Choice choose_recipe(const Image& picture) {
    const Traits traits = traits_of(picture);
    if (traits.two_tone >= kTwoTone && traits.paper >= kInkOnPaper && traits.colourful < 0.1 && traits.flat >= kDrawnFlat)
        return {"line-art", "dark lines on light ground: " + percent(traits.two_tone) + " is one or the other"};
    if (traits.few >= kDrawnFew && traits.flat >= kDrawnFlat) {
        const std::string seen = percent(traits.flat) + " flat, eight greys cover " + percent(traits.few);
        if (traits.paper >= kPaper) return {"diagram", "drawn on one ground: " + seen};
        if (traits.colourful >= kMapColour) return {"map", "coloured regions: " + seen};
    }
    return {"photo", "continuous tones: " + std::to_string(traits.greys) + " grey levels, " + percent(traits.flat) + " flat"};
}

}  // namespace tactics
