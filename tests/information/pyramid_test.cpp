// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/pyramid.h"

#include <gtest/gtest.h>

#include "tactics/information/code_length.h"
#include "tactics/information/entropy.h"
#include "tests/information/sources.h"

namespace tactics::tests::pyramid_test {
namespace {

TEST(Pyramid, ACellIsTheMeanOrTheHighestOfThoseInIt) {
    const LevelGrid grid = noise(24, 12, 256, 1);
    const LevelGrid mean = resampled(grid, 8, Pooling::mean), highest = resampled(grid, 8, Pooling::highest);
    ASSERT_EQ(mean.columns, 8);
    ASSERT_EQ(mean.rows, 4);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 8; ++i) {
            double sum = 0;
            int most = 0;
            for (int y = 3 * j; y < 3 * j + 3; ++y)
                for (int x = 3 * i; x < 3 * i + 3; ++x) {
                    const int value = grid.values[static_cast<std::size_t>(y * 24 + x)];
                    sum += value;
                    most = std::max(most, value);
                }
            const auto at = static_cast<std::size_t>(j * 8 + i);
            EXPECT_NEAR(mean.values[at], sum / 9, 0.5);
            EXPECT_EQ(highest.values[at], most);
        }
    EXPECT_EQ(resampled(grid, 99, Pooling::mean).values, grid.values);
    EXPECT_EQ(resampled(noise(7, 900, 4, 1), 3, Pooling::mean).columns, 1);
}

TEST(Pyramid, CellsAreEnlargedToWhatTheyWereMadeOf) {
    const LevelGrid grid = noise(30, 17, 16, 2);
    const LevelGrid small = resampled(grid, 9, Pooling::mean);
    const LevelGrid back = enlarged(small, 30, 17);
    EXPECT_EQ(back.count(), grid.count());
    EXPECT_EQ(resampled(back, 9, Pooling::mean).values, small.values);
}

TEST(Pyramid, TheSizesToTryAreDenseAndEndWithTheWhole) {
    for (const int longest : {1, 2, 7, 480, 4000}) {
        const std::vector<int> sizes = sizes_to_try(longest);
        EXPECT_EQ(sizes.back(), longest);
        EXPECT_TRUE(std::is_sorted(sizes.begin(), sizes.end()));
        for (std::size_t i = 1; i < sizes.size(); ++i) EXPECT_LE(sizes[i], 1 + 1.05 * sizes[i - 1]);
    }
    for (const int levels : {2, 5, 256, 65536}) {
        const std::vector<int> numbers = levels_to_try(levels);
        EXPECT_EQ(numbers.front(), 2);
        EXPECT_EQ(numbers.back(), levels);
        for (std::size_t i = 1; i < numbers.size(); ++i)
            EXPECT_LE(numbers[i], std::max(numbers[i - 1] + 1.0, 1.25 * numbers[i - 1]));
    }
}

// Who can show more can show less.
TEST(Pyramid, NothingIsLostByMoreCellsOrLevels) {
    for (const LevelGrid& grid : {terrain(120, 90, 256, 1), noise(60, 80, 16, 2), wall(100, 30, 64)}) {
        Pyramid pyramid(grid, Pooling::mean);
        for (const int levels : {2, 3, 5, 17, 256}) {
            double before = 0;
            for (int longest = 1; longest <= 130; longest += 3) {
                const double bits = pyramid.most_bits(longest, levels);
                EXPECT_GE(bits, before);
                EXPECT_GE(pyramid.most_bits(longest, levels + 1), bits);
                before = bits;
            }
        }
        EXPECT_EQ(pyramid.most_bits(1000, 256), code_length(grid).best.bits);
    }
}

TEST(Pyramid, EachLevelOfDetailTellsLessOfTheSceneAndIsFurtherFromIt) {
    Pyramid pyramid(terrain(256, 192, 256, 3), Pooling::mean);
    double bits = 1e18, mutual = 1e18, error = -1;
    for (int longest = 256; longest >= 8; longest /= 2) {
        const LevelGrid back = enlarged(pyramid.at(longest), 256, 192);
        const double told = joint_entropy(pyramid.whole(), back).mutual();
        EXPECT_LT(pyramid.bits(longest, 256), bits);
        EXPECT_LT(told, mutual);
        EXPECT_GT(pyramid.error(longest, 256), error);
        bits = pyramid.bits(longest, 256);
        mutual = told;
        error = pyramid.error(longest, 256);
    }
    EXPECT_EQ(pyramid.error(256, 256), 0);
    // Steps of s are wrong by s / sqrt(12).
    EXPECT_NEAR(pyramid.error(256, 16), 16 / std::sqrt(12), 0.3);
}

}  // namespace
}  // namespace tactics::tests::pyramid_test
