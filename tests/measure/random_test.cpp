// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tactics::random_test {
namespace {

TEST(RandomNumbers, AreThoseOfSplitmix64) {
    RandomNumbers random(1234567);
    EXPECT_EQ(random.next(), 6457827717110365317u);
    EXPECT_EQ(random.next(), 3203168211198807973u);
    EXPECT_EQ(random.next(), 9817491932198370423u);
    EXPECT_NE(seed_of(1, 0), seed_of(0, 1));
}

TEST(RandomNumbers, NormalsHaveTheMomentsAndTailsOfANormalDistribution) {
    RandomNumbers random(7);
    constexpr int kPairs = 200'000;
    double sum = 0, squares = 0, product = 0;
    int beyond = 0;
    for (int i = 0; i < kPairs; ++i) {
        const auto [x, y] = random.normals();
        sum += x + y;
        squares += x * x + y * y;
        product += x * y;
        beyond += (std::abs(x) > 2) + (std::abs(y) > 2);
    }
    EXPECT_NEAR(sum / (2 * kPairs), 0, 0.007);
    EXPECT_NEAR(squares / (2 * kPairs), 1, 0.01);
    EXPECT_NEAR(product / kPairs, 0, 0.01);
    EXPECT_NEAR(static_cast<double>(beyond) / (2 * kPairs), 0.0455, 0.0015);
}

TEST(RandomNumbers, BelowGivesEachAsOften) {
    RandomNumbers random(3);
    std::array<int, 6> times{};
    for (int i = 0; i < 60'000; ++i) ++times.at(random.below(6));
    for (const int one : times) EXPECT_NEAR(one, 10'000, 400);
}

}  // namespace
}  // namespace tactics::random_test
