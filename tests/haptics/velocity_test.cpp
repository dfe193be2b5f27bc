// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/sensing/velocity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace tactics::velocity_test {
namespace {

constexpr double kTick = 0.001;  // s

// What is told at each tick of a place that is known to `lump` mm; 0: exactly.
std::vector<double> told(const std::function<double(double time)>& place, double lump, double seconds) {
    const auto known = [&](double time) { return lump > 0 ? std::floor(place(time) / lump) * lump : place(time); };
    AdaptiveVelocity course;
    std::vector<double> velocities;
    for (int tick = 1; tick * kTick <= seconds; ++tick) {
        course.step({known(tick * kTick) - known((tick - 1) * kTick), 0}, kTick);
        velocities.push_back(course.velocity().x);
    }
    return velocities;
}

TEST(AdaptiveVelocity, EvenMotionIsExact) {
    for (const double speed : {0.0, 5.0, 100.0, -250.0})
        for (const double velocity : told([=](double time) { return speed * time; }, 0, 0.1)) EXPECT_NEAR(velocity, speed, 1e-6);
}

TEST(AdaptiveVelocity, ABrakingHandIsKnownWithinTwoTicks) {
    constexpr double kBegin = 0.05, kBraking = 2500;  // s, mm/s2
    for (const double speed : {25.0, 50.0, 100.0}) {
        const double stop = speed / kBraking;
        const auto place = [&](double time) {
            const double braked = std::min(std::max(0.0, time - kBegin), stop);
            return speed * std::min(time, kBegin) + speed * braked - kBraking * braked * braked / 2;
        };
        const std::vector<double> velocities = told(place, 0, kBegin + stop + 0.01);
        for (std::size_t tick = 0; tick < velocities.size(); ++tick) {
            const double time = static_cast<double>(tick + 1) * kTick;
            const double true_speed = speed - kBraking * std::clamp(time - kBegin, 0.0, stop);
            EXPECT_LT(velocities[tick] - true_speed, 2.01 * kTick * kBraking) << time;
            EXPECT_GT(velocities[tick] - true_speed, -kTick * kBraking) << time;
        }
    }
}

// 31.5 counts a mm, as optical mice have them.
TEST(AdaptiveVelocity, LumpsOfCountsAreAveraged) {
    constexpr double kLump = 1 / 31.5;
    for (const double speed : {20.0, 50.0, 100.0}) {
        const std::vector<double> velocities = told([=](double time) { return speed * time; }, kLump, 1);
        double squares = 0;
        for (std::size_t tick = 100; tick < velocities.size(); ++tick)
            squares += (velocities[tick] - speed) * (velocities[tick] - speed);
        // Differences from tick to tick are a whole lump wrong now and then.
        EXPECT_LT(std::sqrt(squares / static_cast<double>(velocities.size() - 100)), kLump / kTick / 4) << speed;
    }
}

TEST(AdaptiveVelocity, ADirectionIsKept) {
    AdaptiveVelocity course;
    for (int tick = 0; tick < 50; ++tick) course.step({0.03, -0.04}, kTick);
    EXPECT_NEAR(course.velocity().x, 30, 1e-9);
    EXPECT_NEAR(course.velocity().y, -40, 1e-9);
    course.begin_again();
    EXPECT_EQ(course.velocity().x, 0);
}

TEST(AdaptiveVelocity, WhatCannotBeIsPassedOver) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN(), kEndless = std::numeric_limits<double>::infinity();
    AdaptiveVelocity course;
    for (int tick = 0; tick < 20; ++tick) course.step({0.1, 0}, kTick);
    for (const Point moved : {Point{kNone, 0}, Point{0, kEndless}}) course.step(moved, kTick);
    for (const double dt : {0.0, -kTick, kNone, kEndless}) course.step({0.1, 0}, dt);
    EXPECT_NEAR(course.velocity().x, 100, 1e-9);
    for (int tick = 0; tick < 100; ++tick) course.step({1e300, -1e300}, kTick);
    for (int tick = 0; tick < 100; ++tick) course.step({0.1, 0}, kTick);
    EXPECT_TRUE(std::isfinite(course.velocity().x));
}

}  // namespace
}  // namespace tactics::velocity_test
