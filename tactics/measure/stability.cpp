// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/stability.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tactics/measure/disturbance.h"
#include "tactics/measure/score.h"

namespace tactics {

namespace {

constexpr int kWidth = 480, kHeight = 320;  // of about the photographs' size
constexpr double kRadius = 90;

using Colour = std::array<std::uint8_t, 3>;

double from_middle(int x, int y) { return std::hypot(x + 0.5 - kWidth / 2.0, y + 0.5 - kHeight / 2.0); }

Image flat() { return make_image(kWidth, kHeight, 1, 0, 128); }

Image ramp() {
    Image image = flat();
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) image.row(y)[x] = static_cast<std::uint8_t>(64 + x * 128 / kWidth);
    return image;
}

// Noise that was smeared over 5 pixels: grains without a contour.
Image grains() {
    const Image noise = with_noise(flat(), 60, 3);
    Image image = noise;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            int sum = 0;
            for (int dy = -2; dy <= 2; ++dy)
                for (int dx = -2; dx <= 2; ++dx)
                    sum += noise.row(std::clamp(y + dy, 0, kHeight - 1))[std::clamp(x + dx, 0, kWidth - 1)];
            image.row(y)[x] = static_cast<std::uint8_t>(std::clamp(128 + (sum / 25 - 128) * 4, 0, 255));
        }
    return image;
}

Image disc(Colour inside, Colour outside, int channels) {
    Image image = make_image(kWidth, kHeight, channels, 0, 0);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            std::copy_n((from_middle(x, y) <= kRadius ? inside : outside).begin(), channels, image.row(y) + x * channels);
    return image;
}

PixelSet nothing() { return {kWidth, kHeight, {}}; }

// The outermost pixels of the disc.
PixelSet circle() {
    PixelSet set = nothing();
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            if (from_middle(x, y) > kRadius) continue;
            const double farthest =
                std::max({from_middle(x + 1, y), from_middle(x - 1, y), from_middle(x, y + 1), from_middle(x, y - 1)});
            if (farthest > kRadius) set.pixels.push_back(static_cast<std::uint32_t>(y * kWidth + x));
        }
    return set;
}

}  // namespace

double agreement(const PixelSet& before, const PixelSet& after) {
    if (before.pixels.empty() || after.pixels.empty()) return before.pixels.empty() == after.pixels.empty() ? 1 : 0;
    Matching matching(before, reach_of(before.width, before.height));
    matching.match(after);
    return 2 * static_cast<double>(matching.pairs()) / static_cast<double>(before.pixels.size() + after.pixels.size());
}

std::vector<KnownPicture> known_pictures() {
    constexpr double kGrain = 10;
    // Both colours have luma 128 (ITU-R BT.601): a detector of greys sees one flat field.
    constexpr Colour kRed = {214, 92, 90}, kGreen = {60, 160, 143};
    std::vector<KnownPicture> known;
    known.push_back({SourceWords("flat"), "one grey", flat(), nothing()});
    known.push_back({SourceWords("ramp"), "grey rising evenly from 64 to 192", ramp(), nothing()});
    known.push_back({SourceWords("flat, noise"), "with noise of 10 grey levels", with_noise(flat(), kGrain, 1), nothing()});
    known.push_back({SourceWords("ramp, noise"), "with noise of 10 grey levels", with_noise(ramp(), kGrain, 2), nothing()});
    known.push_back({SourceWords("texture"), "grains 5 pixels large without any contour", grains(), nothing()});
    known.push_back({SourceWords("faint disc"), "a disc 4 grey levels above its ground, with noise of 3",
                     with_noise(disc({132}, {128}, 1), 3, 4), circle()});
    known.push_back({SourceWords("colour disc"), "a disc of another colour and the same grey", disc(kRed, kGreen, 3), circle()});
    return known;
}

double ink_of(const PixelSet& lines) {
    return static_cast<double>(lines.pixels.size()) / (static_cast<double>(lines.width) * lines.height);
}

}  // namespace tactics
