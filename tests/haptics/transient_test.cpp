// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/transient.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tactics::transient_test {
namespace {

double roof(double x) { return 20 - 1.5 * std::abs(x); }

struct Felt {
    double before = 0, after = 0, fading = 0,
           late = 0;  ///< the largest force on the way to the edge, over it, 2 mm and well behind it
};

Felt walk(double rate, double speed) {
    EdgeTransient transient({}, rate);
    Felt felt;
    for (double x = -10; x < 20; x += speed / rate) {
        const double force = std::abs(transient.force(roof(x), {x, 0}, 1 / rate));
        double& most = x < 0 ? felt.before : x < 2 ? felt.after : x < 10 ? felt.fading : felt.late;
        most = std::max(most, force);
    }
    return felt;
}

TEST(Transient, IsFeltAtTheEdgeAndNowhereElse) {
    const Felt felt = walk(4000, 100);
    EXPECT_EQ(felt.before, 0);
    EXPECT_GT(felt.after, 0.25);
    EXPECT_LE(felt.after, 0.5);
    EXPECT_LT(felt.fading, 0.3 * felt.after);  // 20 ms, two decays and a half
    EXPECT_EQ(felt.late, 0);
}

TEST(Transient, GrowsWithTheSpeed) {
    EXPECT_NEAR(walk(8000, 100).after / walk(8000, 50).after, 2, 0.1);
    EXPECT_LE(walk(8000, 1000).after, TransientSettings{}.most_force);
}

TEST(Transient, SwingsAsFastAsTheLoopCanAndIsSilentInASlowOne) {
    EXPECT_EQ(transient_frequency({}, 4000), 250);
    EXPECT_EQ(transient_frequency({}, 1000), 100);
    EXPECT_EQ(transient_frequency({}, 900), 0);
    EXPECT_GT(walk(1000, 100).after, 0.2);
    EXPECT_EQ(walk(900, 100).after, 0);
}

TEST(Transient, FlatGroundIsSilent) {
    EdgeTransient transient({}, 4000);
    for (int tick = 0; tick < 4000; ++tick) ASSERT_EQ(transient.force(10, {tick * 0.05, 0}, 0.00025), 0);
}

}  // namespace
}  // namespace tactics::transient_test
