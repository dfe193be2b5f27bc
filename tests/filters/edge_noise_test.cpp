// SPDX-License-Identifier: Apache-2.0
// What a faint edge stands above: the picture's noise and its slope, each measured by its own sign. Sobel and k-means
// together, as the pilot study had them.
#include "filters/edge_noise.h"

#include <gtest/gtest.h>

#include <set>

#include "tactics/units.h"
#include "tests/filters/pictures.h"

namespace tactics::edge_noise_test {
namespace {

using namespace pictures;

constexpr int kWidth = 240, kHeight = 180;
constexpr double kRadius = 50;

double away(int x, int y) { return std::hypot(x - 120, y - 90); }

/// A disc `step` above a ground that rises to the right by `slope` a pixel, with noise. On such a ramp all differences from
/// which noise is measured are 0.
Image disc_on(double slope, double step, double noise, std::uint64_t seed) {
    Chance chance(seed);
    return drawn(kWidth, kHeight, [&](int x, int y) {
        return 60 + slope * x + (away(x, y) < kRadius ? step : 0) + (noise > 0 ? noise * chance.normal() : 0);
    });
}

EdgeMap strong_edges(const Image& image, double blur) {
    return filtered_edges("kmeans", std::get<EdgeMap>(filtered("sobel blur=" + to_text(blur) + "mm", image)));
}

// The share of 72 directions from the disc's middle with ink on its rim; ink elsewhere counts against it.
struct Found {
    std::size_t rim = 0, elsewhere = 0;
};
Found found_in(const Image& image, double blur) {
    const EdgeMap edges = strong_edges(image, blur);
    std::set<int> directions;
    Found found;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            if (edges.strength[static_cast<std::size_t>(y * kWidth + x)] <= 0) continue;
            if (std::abs(away(x, y) - kRadius) > 3 + 3 * blur / kPixel)
                ++found.elsewhere;
            else
                directions.insert(static_cast<int>(36 + 36 / std::numbers::pi * std::atan2(y - 90, x - 120)) % 72);
        }
    found.rim = directions.size();
    return found;
}

TEST(FaintEdges, OfADiscAreFoundAboveNoise) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        // The scale of the noise is 3 / (2 * 6 pixels) then.
        const Found found = found_in(disc_on(0, 4, 3, seed), 1.5);
        EXPECT_EQ(found.rim, 72u);
        EXPECT_EQ(found.elsewhere, 0u);
    }
}

TEST(FaintEdges, OfADiscAreFoundOnACleanGround) {
    for (const double blur : {0.0, 0.3, 0.5, 1.5}) {
        const Found found = found_in(disc_on(0, 4, 0, 1), blur);
        EXPECT_EQ(found.rim, 72u) << blur;
        EXPECT_EQ(found.elsewhere, 0u) << blur;
    }
}

TEST(FaintEdges, OfADiscAreFoundOnACleanRamp) {
    for (const double slope : {0.02, 0.05, 0.1, 0.2})
        for (const double blur : {0.3, 0.5}) {
            const Found found = found_in(disc_on(slope, 4, 0, 1), blur);
            EXPECT_GE(found.rim, slope < 0.2 ? 70u : 50u) << slope << ", blur " << blur;
            EXPECT_EQ(found.elsewhere, 0u) << slope << ", blur " << blur;
        }
}

TEST(FaintEdges, AreNotMadeOfNothing) {
    for (const double slope : {0.0, 0.02, 0.1, 0.2, 0.37, 0.5, 0.6})
        for (const double noise : {0.0, 0.3, 1.0, 3.0, 10.0})
            for (const double blur : {0.0, 0.3, 0.5, 1.5})
                EXPECT_EQ(count_set(strong_edges(disc_on(slope, 0, noise, 7), blur)), 0u)
                    << "slope " << slope << ", noise " << noise << ", blur " << blur;
}

// No noise is an answer, and not the same as none measured.
TEST(NoiseFloor, TakesNoNoiseForAnAnswer) {
    EdgeMap map;
    map.width = 100;
    map.height = 10;
    map.mm_per_pixel = kPixel;
    map.strength.assign(1000, 3.0f);
    const float unmeasured = noise_floor(map);
    map.noise = 0.0f;
    EXPECT_FLOAT_EQ(noise_floor(map), 3 + kStaircase);
    EXPECT_GT(unmeasured, 15);
    map.noise = noise_of(map);
    EXPECT_FLOAT_EQ(noise_floor(map), unmeasured);
}

}  // namespace
}  // namespace tactics::edge_noise_test
