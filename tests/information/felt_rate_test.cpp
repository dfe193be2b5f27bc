// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/felt_rate.h"

#include <gtest/gtest.h>

#include "tactics/information/code_length.h"
#include "tests/information/sources.h"

namespace tactics::tests::felt_rate_test {
namespace {

LevelGrid normal_noise(double deviation) {
    RandomNumbers random(1);
    return grid_by(256, 256, 4096, [&](int, int) {
        double sum = 0;
        for (int i = 0; i < 12; ++i) sum += random.uniform();  // about normal, of deviation 1
        return std::clamp(std::round(2048 + deviation * (sum - 6)), 0.0, 4095.0);
    });
}

// Of white noise R(D) is log2(deviation / error).
TEST(FeltRate, OfWhiteNoiseIsWhatTheBookSays) {
    const LevelGrid grid = normal_noise(300);
    for (const double error : {10.0, 40.0, 150.0}) EXPECT_NEAR(gaussian_rate(grid, error), std::log2(300 / error), 0.02) << error;
    EXPECT_NEAR(gaussian_rate(grid, 320), 0, 0.02);
    EXPECT_EQ(gaussian_rate(grid, 1000), 0);
}

TEST(FeltRate, AWaveNeedsNextToNothingAndAPlaneNothing) {
    const LevelGrid plane = grid_by(200, 150, 4096, [](int x, int y) { return 5 * x + 7 * y; });
    EXPECT_LT(gaussian_rate(plane, 5), 1e-6);
    const LevelGrid wave = grid_by(256, 256, 4096, [](int x, int) { return std::round(2000 + 1000 * std::sin(x * 0.3)); });
    EXPECT_LT(gaussian_rate(wave, 10), 0.02);
}

TEST(FeltRate, FallsWithTheErrorAndIsNeverOverTheCode) {
    for (const LevelGrid& grid : {terrain(200, 160, 256, 3), wall(200, 160, 256), noise(100, 80, 256, 2)}) {
        double before = neighbour_bits(grid) * 1.0001 + 1;
        for (const double error : {0.3, 1.0, 3.0, 10.0, 30.0, 300.0}) {
            const double bits = felt_bits(grid, error);
            EXPECT_LE(bits, before * 1.02 + 20) << error;
            before = bits;
        }
        EXPECT_LE(before, 1);
    }
    EXPECT_LT(felt_bits(wall(344, 403, 256), 6.4), 300);  // a Gaussian of its spectrum would need many times as much
}

TEST(FeltRate, BearsWhatIsHardlyThere) {
    EXPECT_LE(felt_bits({1, 1, 1, 65536, {9}}, 1), 16);
    EXPECT_GE(felt_bits(noise(1, 300, 16, 1), 0.5), 0);
    EXPECT_GE(felt_bits(noise(7, 3, 65536, 1), 1e9), 0);
    EXPECT_THROW(felt_bits(noise(4, 4, 4, 1), 0), std::logic_error);
    const LevelGrid flat = noise(20, 400, 64, 5);
    const LevelGrid voxels{20, 20, 20, 64, words_of(flat)};
    EXPECT_GT(gaussian_rate(voxels, 1), 3);
}

// Forces of 0.01 to 0.88 N and to 1.75 N, of the paper's Omni and Desktop.
TEST(FeltRate, ForcesAreToldApartInSteps) {
    EXPECT_EQ(weber_levels(0.01, 0.88), 47);
    EXPECT_EQ(weber_levels(0.01, 1.75), 54);
    EXPECT_EQ(weber_levels(1, 1), 1);
    EXPECT_EQ(weber_levels(0, 1), 1);
}

}  // namespace
}  // namespace tactics::tests::felt_rate_test
