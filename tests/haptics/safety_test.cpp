// SPDX-License-Identifier: Apache-2.0
// Whatever force a scene wishes for, a finger is not hurt.
#include "tactics/haptics/loop/safety.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace tactics::safety_test {
namespace {

constexpr double kTick = 0.001;

Safety warm(const SafetyLimits& limits) {
    Safety safety(limits);
    for (int i = 0; i < 1000; ++i) safety.pass({0, 0, 0}, kTick);
    return safety;
}

TEST(Safety, IsFiniteAndWithinItsLimitsWhateverIsWished) {
    const SafetyLimits limits;
    Safety safety(limits);
    std::mt19937 random(1);
    const double odd[] = {
        std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 1e300, -1e300, 0, 7, -7};
    double last = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double dt = random() % 50 == 0 ? odd[random() % 8] : kTick;
        const double force = safety.pass({0, 0, odd[random() % 8]}, dt).z;
        ASSERT_TRUE(std::isfinite(force));
        ASSERT_LE(std::abs(force), limits.most_force);
        const double step = limits.most_slew * std::clamp(std::isfinite(dt) ? dt : 0, 0.0, limits.most_dt);
        ASSERT_LE(std::abs(force - last), step + 1e-12);
        last = force;
    }
    EXPECT_GT(safety.not_finite(), 30'000u);
    EXPECT_GT(safety.too_late(), 0u);
}

TEST(Safety, BeginsSoftly) {
    const SafetyLimits limits;
    Safety safety(limits);
    for (int i = 1; i <= 300; ++i) EXPECT_LE(safety.pass({0, 0, 8}, kTick).z, 8.0 * i / 300 + 1e-9);
    EXPECT_NEAR(safety.pass({0, 0, 8}, kTick).z, 8, 1e-9);
    // After a pause again.
    safety.pass({0, 0, 8}, 0.02);
    EXPECT_LT(safety.pass({0, 0, 8}, kTick).z, 1);
}

TEST(Safety, WhatIsWishedIsGivenWhereNothingForbidsIt) {
    Safety safety = warm({});
    EXPECT_DOUBLE_EQ(safety.pass({0, 0, 2.5}, kTick).z, 2.5);
    EXPECT_DOUBLE_EQ(safety.pass({0, 0, -1}, kTick).z, -1);
    EXPECT_DOUBLE_EQ(safety.pass({0, 0, 8}, kTick).z, 3);  // 4 N a millisecond
}

TEST(Safety, StopsWithinFiveMilliseconds) {
    Safety safety = warm({});
    for (int i = 0; i < 10; ++i) safety.pass({0, 0, 8}, kTick);
    safety.stop();
    for (int i = 0; i < 5; ++i) safety.pass({0, 0, 8}, kTick);
    EXPECT_EQ(safety.pass({0, 0, 8}, kTick).z, 0);
    EXPECT_EQ(safety.pass({0, 0, -8}, kTick).z, 0);
}

}  // namespace
}  // namespace tactics::safety_test
