// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace tactics::matching_test {
namespace {

PixelSet random_set(std::mt19937& random, int width, int height, unsigned most) {
    std::set<std::uint32_t> pixels;
    const unsigned count = static_cast<unsigned>(random() % (most + 1));
    for (unsigned i = 0; i < count; ++i)
        pixels.insert(static_cast<std::uint32_t>(random() % static_cast<unsigned>(width * height)));
    return {width, height, {pixels.begin(), pixels.end()}};
}

bool near(const PixelSet& set, std::uint32_t a, std::uint32_t b, double reach) {
    const auto width = static_cast<std::uint32_t>(set.width);
    const int x = static_cast<int>(a % width) - static_cast<int>(b % width);
    const int y = static_cast<int>(a / width) - static_cast<int>(b / width);
    return x * x + y * y <= reach * reach;
}

// Tries every partner of each line pixel, and none.
std::size_t best_by_force(const PixelSet& truth, const PixelSet& lines, double reach, std::size_t line,
                          std::vector<bool>& taken) {
    if (line == lines.pixels.size()) return 0;
    std::size_t best = best_by_force(truth, lines, reach, line + 1, taken);
    for (std::size_t t = 0; t < truth.pixels.size(); ++t) {
        if (taken[t] || !near(truth, truth.pixels[t], lines.pixels[line], reach)) continue;
        taken[t] = true;
        best = std::max(best, 1 + best_by_force(truth, lines, reach, line + 1, taken));
        taken[t] = false;
    }
    return best;
}

std::size_t best_by_force(const PixelSet& truth, const PixelSet& lines, double reach) {
    std::vector<bool> taken(truth.pixels.size(), false);
    return best_by_force(truth, lines, reach, 0, taken);
}

std::size_t pairs(const PixelSet& truth, const PixelSet& lines, double reach) {
    Matching matching(truth, reach);
    matching.match(lines);
    return matching.pairs();
}

TEST(Matching, IsTheBestThereIs) {
    std::mt19937 random(7);
    for (int i = 0; i < 3000; ++i) {
        const PixelSet truth = random_set(random, 7, 6, 7), lines = random_set(random, 7, 6, 7);
        const double reach = 0.4 * static_cast<double>(random() % 8);
        EXPECT_EQ(pairs(truth, lines, reach), best_by_force(truth, lines, reach)) << i;
    }
}

// Lines come and go; the pairs are as many as if the last state were the first.
TEST(Matching, FollowsChanges) {
    std::mt19937 random(11);
    for (int i = 0; i < 100; ++i) {
        const PixelSet truth = random_set(random, 30, 30, 150);
        Matching matching(truth, 2.5);
        for (int change = 0; change < 8; ++change) {
            const PixelSet lines = random_set(random, 30, 30, 300);
            matching.match(lines);
            EXPECT_EQ(matching.pairs(), pairs(truth, lines, 2.5));
            const auto paired = std::count_if(lines.pixels.begin(), lines.pixels.end(),
                                              [&](std::uint32_t pixel) { return matching.has_pair(pixel); });
            EXPECT_EQ(static_cast<std::size_t>(paired), matching.pairs());
        }
    }
}

TEST(Matching, OfAGrowingSetLosesNobody) {
    std::mt19937 random(13);
    for (int i = 0; i < 100; ++i) {
        const PixelSet truth = random_set(random, 30, 30, 150), all = random_set(random, 30, 30, 300);
        Matching matching(truth, 2.5);
        std::vector<std::uint32_t> had;
        for (unsigned modulus = 4; modulus > 0; --modulus) {
            PixelSet some{30, 30, {}};
            for (const std::uint32_t pixel : all.pixels)
                if (pixel % 4 >= modulus - 1) some.pixels.push_back(pixel);
            matching.match(some);
            EXPECT_EQ(matching.pairs(), pairs(truth, some, 2.5));
            for (const std::uint32_t pixel : had) EXPECT_TRUE(matching.has_pair(pixel));
            had.clear();
            std::copy_if(some.pixels.begin(), some.pixels.end(), std::back_inserter(had),
                         [&](std::uint32_t pixel) { return matching.has_pair(pixel); });
        }
    }
}

TEST(Matching, IsTheSameBothWays) {
    std::mt19937 random(17);
    for (int i = 0; i < 50; ++i) {
        const PixelSet a = random_set(random, 60, 40, 600), b = random_set(random, 60, 40, 600);
        EXPECT_EQ(pairs(a, b, 3.2), pairs(b, a, 3.2));
        EXPECT_EQ(pairs(a, a, 3.2), a.pixels.size());
    }
}

TEST(Matching, ReachesAsFarAsItMayAndNoFarther) {
    PixelSet column{50, 50, {}}, moved{50, 50, {}};
    for (std::uint32_t y = 0; y < 50; ++y) {
        column.pixels.push_back(y * 50 + 20);
        moved.pixels.push_back(y * 50 + 23);
    }
    EXPECT_EQ(pairs(column, moved, 3), 50u);
    EXPECT_EQ(pairs(column, moved, 2.99), 0u);
    // A row's end is no neighbour of the next row's beginning.
    EXPECT_EQ(pairs({50, 50, {49}}, {50, 50, {50}}, 3), 0u);
    EXPECT_EQ(pairs({50, 50, {50}}, {50, 50, {49}}, 3), 0u);
    EXPECT_EQ(pairs({50, 50, {}}, moved, 3), 0u);
}

// A long way has to be led back: each line pixel gives up its place to the one before.
TEST(Matching, LeadsAWholeChainOn) {
    PixelSet truth{300, 1, {}}, lines{300, 1, {}};
    for (std::uint32_t x = 1; x < 300; ++x) truth.pixels.push_back(x);
    for (std::uint32_t x = 1; x < 299; ++x) lines.pixels.push_back(x);
    Matching matching(truth, 1);
    matching.match(lines);
    EXPECT_EQ(matching.pairs(), 298u);
    lines.pixels.insert(lines.pixels.begin(), 0);
    matching.match(lines);
    EXPECT_EQ(matching.pairs(), 299u);
}

}  // namespace
}  // namespace tactics::matching_test
