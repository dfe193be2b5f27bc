// SPDX-License-Identifier: Apache-2.0
// What a code must find or cannot; known_entropy_test.cpp holds the interval against sources.
#include "tactics/information/code_length.h"

#include <gtest/gtest.h>

#include "tactics/information/measures.h"
#include "tests/information/sources.h"

namespace tactics::tests::code_length_test {
namespace {

TEST(CodeLength, OfNoiseIsAboutAsItIsWritten) {
    for (const int levels : {2, 16, 256, 4096, 65536}) {
        const LevelGrid grid = noise(300, 200, levels, 7);
        const CodeLength length = code_length(grid);
        EXPECT_LE(length.best.bits, raw_bits(grid));
        EXPECT_GT(length.best.bits, 0.99 * raw_bits(grid)) << levels;
        EXPECT_LT(measure(grid, {}).topology, 0.001 + (levels > 256 ? 0.5 : 0)) << levels;  // few are seen of many levels
    }
}

TEST(CodeLength, OfAWallIsNearlyNothing) {
    const LevelGrid grid = wall(344, 403, 256);
    EXPECT_LT(code_length(grid).best.bits, 0.01 * static_cast<double>(grid.count()));
    EXPECT_GT(measure(grid, {}).topology, 0.98);
}

TEST(CodeLength, ShufflingLeavesLevelsAndRaisesTheCode) {
    for (const int levels : {8, 256, 4096}) {
        const LevelGrid relief = terrain(200, 160, levels, 4), mixed = shuffled(relief, 5);
        EXPECT_DOUBLE_EQ(entropy_of(relief).corrected, entropy_of(mixed).corrected);
        EXPECT_GT(code_length(mixed).spatial.bits, 1.3 * code_length(relief).spatial.bits) << levels;
        EXPECT_GT(measure(relief, {}).topology, 0.25) << levels;
        EXPECT_LT(measure(mixed, {}).topology, 0.02) << levels;
    }
}

TEST(CodeLength, OfMoreTheIntervalIsNarrower) {
    const auto width = [](int side) {
        const Measures measures = measure(terrain(side, side, 256, 6), {});
        return (measures.high - measures.low) / (side * side);
    };
    EXPECT_LT(width(200), width(100));
    EXPECT_LT(width(400), width(200));
}

// Two threads count what one counts: a grid of a million cells, and the same with rows that say nothing in between.
TEST(CodeLength, DoesNotHangOnHowManyThreadsCount) {
    const LevelGrid small = terrain(500, 400, 256, 8);
    const LevelGrid large = repeated(small, 6, false);
    const double once = code_length(small).best.learnt, six = code_length(large).best.learnt;
    EXPECT_NEAR(six, 6 * once, 0.01 * six);
    EXPECT_EQ(code_length(large).best.bits, code_length(large).best.bits);
}

// Voxels that go on from slice to slice say nothing new there, which who looks at one slice alone cannot know.
TEST(CodeLength, OfVoxelsSeesTheSliceBefore) {
    const LevelGrid slice = noise(40, 40, 16, 9);
    const LevelGrid pillars = repeated(slice, 10, true);
    EXPECT_LT(code_length(pillars).best.bits, 2.5 * raw_bits(slice));
    EXPECT_GT(code_length(pillars).best.bits, 0.95 * raw_bits(slice));
}

TEST(CodeLength, BearsWhatIsHardlyThere) {
    EXPECT_LE(code_length({1, 1, 1, 65536, {65535}}).best.bits, 16);
    EXPECT_LT(code_length(wall(1, 900, 2)).best.bits, 64);
    EXPECT_LT(code_length(grid_by(100, 100, 65536, [](int, int) { return 777; })).best.bits, 64);
    EXPECT_GE(code_length(noise(1, 50, 3, 1)).best.bits, 0);
    EXPECT_GE(code_length(noise(50, 1, 3, 1)).best.bits, 0);
    EXPECT_GE(code_length(noise(2, 2, 65536, 1)).best.bits, 0);
}

// The errors of prediction of a terrain, counted one by one as the header says; the row before the first is zero.
TEST(CodeLength, PredictionIsThatOfJpegLs) {
    for (const int columns : {128, 129}) {
        const LevelGrid grid = terrain(columns, 90, 256, 3);
        const std::vector<std::uint16_t> words = words_of(grid);
        const auto at = [&](int x, int y) {
            return y < 0 ? 0 : static_cast<int>(words[static_cast<std::size_t>(y * columns + std::clamp(x, 0, columns - 1))]);
        };
        std::vector<std::uint32_t> counts(16 * 256);
        for (int y = 0; y < grid.rows; ++y)
            for (int x = 0; x < columns; ++x) {
                const int a = x > 0 ? at(x - 1, y) : at(0, y - 1), b = at(x, y - 1), c = at(x - 1, y - 1), d = at(x + 1, y - 1);
                const int predicted = c >= std::max(a, b) ? std::min(a, b) : c <= std::min(a, b) ? std::max(a, b) : a + b - c;
                int rough = std::abs(a - c) + std::abs(b - c) + std::abs(b - d), width = 0;
                for (; rough > 0; rough /= 2) ++width;
                ++counts[static_cast<std::size_t>(width * 256 + (at(x, y) - predicted + 256) % 256)];
            }
        EXPECT_NEAR(code_length(grid).spatial.learnt, adaptive_code(counts, 256).learnt, 1e-6) << columns;
    }
}

// With the doubt and without it, what is written is the same: amounts are compared. Here values hang on those above.
TEST(CodeLength, DoesNotHangOnWhetherTheDoubtIsAsked) {
    RandomNumbers random(4);
    std::vector<int> up(300, 0);
    const LevelGrid grid = grid_by(300, 300, 2, [&](int x, int y) {
        int& above = up[static_cast<std::size_t>(x)];  // the last five, as bits
        const int value = y < 5 || random.uniform() < 0.02 ? static_cast<int>(random.below(2)) : (above >> 4 ^ above) & 1;
        above = (above << 1 | value) & 31;
        return value;
    });
    const CountedRows rows(grid);
    const CodeLength with = code_length(rows, counts_of(grid)), without = code_length(grid);
    EXPECT_EQ(with.best.bits, without.best.bits);
    EXPECT_EQ(with.spatial.bits, without.spatial.bits);
    EXPECT_LT(without.best.bits, 0.3 * static_cast<double>(grid.count()));
    EXPECT_GT(with.doubt, 0);
}

// The adaptive code is what coding value by value takes, whatever the order.
TEST(CodeLength, TheAdaptiveCodeIsTheSumOfItsSteps) {
    const LevelGrid grid = noise(30, 7, 5, 3);
    std::vector<std::uint32_t> counts(5);
    double bits = 0, seen = 0;
    for (const std::uint16_t value : words_of(grid)) {
        bits -= std::log2((counts[value] + 0.5) / (seen + 2.5));
        ++counts[value];
        ++seen;
    }
    EXPECT_NEAR(adaptive_code(counts, 5).bits, bits, 1e-8);
    std::vector<std::uint32_t> large = {3'000'000, 5, 0, 70'000};
    EXPECT_GT(adaptive_code(large, 4).bits, adaptive_code(large, 4).learnt);
}

}  // namespace
}  // namespace tactics::tests::code_length_test
