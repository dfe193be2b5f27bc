// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "tactics/error.h"

namespace tactics::stream_test {
namespace {

// A tick each millisecond; forces in steps of 0.01 N.
Recording recording(std::size_t ticks, const std::function<Steps3(std::size_t tick)>& force) {
    Recording made;
    made.force_step = 0.01;
    made.spatial = true;
    for (std::size_t i = 0; i < ticks; ++i) {
        made.times.push_back(static_cast<std::int64_t>(i) * 1000);
        made.places.push_back({static_cast<std::int64_t>(i), 0, 0});
        made.forces.push_back(force(i));
    }
    return made;
}

MediumChannel pushing(double most) { return {.name = "arm", .kind = "arm", .most_force = most}; }

TEST(Stream, OfNoiseIsWhatItsLevelsHold) {
    std::mt19937 random(5);
    constexpr std::size_t kTicks = 40000;
    // 31 levels each way, all as likely.
    const auto any = [&] { return static_cast<std::int64_t>(random() % 31) - 15; };
    const MeasuredStream stream = measured(recording(kTicks, [&](std::size_t) { return Steps3{any(), any(), any()}; }), "noise");
    EXPECT_EQ(stream.levels, 31);
    const double truth = 3 * kTicks * std::log2(31);
    EXPECT_LE(stream.low, truth * 1.001);
    EXPECT_GE(stream.high, truth);
    EXPECT_NEAR(stream.high, truth, 0.02 * truth);
    for (const Measures& along : stream.along) EXPECT_NEAR(along.topology, 0, 0.02);
    EXPECT_GT(stream.felt, kTicks * 9 / 10);  // nothing of it can be guessed
}

TEST(Stream, AForceThatStaysTellsNextToNothing) {
    const MeasuredStream still = measured(recording(20000, [](std::size_t) { return Steps3{0, 0, 150}; }), "still");
    EXPECT_EQ(still.low, 0);
    EXPECT_LT(still.bits, 200);
    EXPECT_LT(still.high, 3 * 200);
    EXPECT_LE(still.felt, 20000 / kTicksOfPart + 1);  // each part of a packed recording begins anew
    EXPECT_DOUBLE_EQ(still.seconds, 19.999);
}

TEST(Stream, AWeakerArmLosesAtLeastAsMuch) {
    std::mt19937 random(9);
    for (int trial = 0; trial < 8; ++trial) {
        double x = 0, z = 100;
        const Recording felt = recording(3000, [&](std::size_t) {
            x += static_cast<double>(random() % 41) - 20;
            z += static_cast<double>(random() % 61) - 30;
            return Steps3{static_cast<std::int64_t>(x), 0, static_cast<std::int64_t>(z)};
        });
        const MeasuredStream stream = measured(felt, "walk");
        double before = 1.1;
        std::size_t cut = felt.forces.size() + 1;
        for (const double most : {0.5, 1.0, 2.0, 4.0, 8.0, 1000.0}) {
            const CarriedForces carried = carried_by(felt, stream, pushing(most));
            EXPECT_LE(carried.loss, before + 0.01) << most;  // the codes learn of each anew
            EXPECT_LE(carried.cut, cut) << most;
            before = carried.loss;
            cut = carried.cut;
        }
        EXPECT_EQ(cut, 0u);
        EXPECT_NEAR(before, 0, 1e-12);  // in its own steps, and all of it
    }
}

TEST(Stream, WhatTellsNothingIsRefused) {
    EXPECT_THROW(measured(recording(1, [](std::size_t) { return Steps3{0, 0, 1}; }), "one.csv"), Error);
    EXPECT_THROW(measured(recording(100, [](std::size_t) { return Steps3{}; }), "air.csv"), Error);
    const Recording felt = recording(10, [](std::size_t tick) { return Steps3{0, 0, static_cast<std::int64_t>(tick)}; });
    EXPECT_THROW(carried_by(felt, measured(felt, "felt"), MediumChannel{}), std::logic_error);
}

}  // namespace
}  // namespace tactics::stream_test
