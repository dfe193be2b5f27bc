// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/simulated/lever.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tactics::lever_test {
namespace {

TEST(Lever, LosesEnergyWithoutAMotor) {
    for (const NamedFinger& finger : kFingers)
        for (const NamedLever& lever : kLevers) {
            // A hand gives energy while it follows to keep its preload; here it does not.
            FingerSettings hand = finger.finger;
            hand.relaxation = 1e9;
            SimulatedLever mouse(lever.lever, hand, 30);
            mouse.throw_at(300);
            double before = mouse.energy();
            const double first = before;
            for (int tick = 0; tick < 500; ++tick) {
                mouse.advance(0.001);
                EXPECT_LE(mouse.energy(), before + 0.002 * first) << finger.name << " " << lever.name << " tick " << tick;
                before = mouse.energy();
            }
            EXPECT_LT(before, 0.9 * first);
        }
}

TEST(Lever, FallsAsABodyFalls) {
    LeverSettings lever;
    lever.damping_ns_per_m = lever.friction = 0;
    SimulatedLever mouse(lever, std::nullopt, 50);
    mouse.advance(0.05);
    EXPECT_NEAR(50 - mouse.true_height(), 0.5 * 9810 * 0.05 * 0.05, 0.02);
    mouse.advance(1);
    EXPECT_EQ(mouse.true_height(), lever.lowest);  // a stop takes all
    EXPECT_EQ(mouse.state().velocity, 0);
}

TEST(Lever, RestsWhereTheForceIsWeightAndPreload) {
    const LeverSettings lever;
    const FingerSettings finger;
    SimulatedLever mouse(lever, finger, 30);
    for (int tick = 0; tick < 1000; ++tick) {
        mouse.push(0.03 * 9.81 + finger.preload);
        mouse.advance(0.001);
    }
    EXPECT_NEAR(mouse.true_height(), 30, 0.01);
    EXPECT_NEAR(pad_force(mouse.state(), finger), finger.preload, 0.01);
}

TEST(Lever, ForceIsClampedNoNumberAndLate) {
    LeverSettings lever;
    lever.delay = 0.0015;
    SimulatedLever strong(lever, std::nullopt, 10), clamped(lever, std::nullopt, 10);
    strong.push(1000);
    clamped.push(lever.most_force);
    strong.advance(0.01);
    clamped.advance(0.01);
    EXPECT_EQ(strong.true_height(), clamped.true_height());

    SimulatedLever late(lever, std::nullopt, 10), never(lever, std::nullopt, 10);
    late.push(8);
    never.push(std::numeric_limits<double>::quiet_NaN());
    late.advance(0.0014);
    never.advance(0.0014);
    EXPECT_EQ(late.true_height(), never.true_height());
    late.advance(0.001);
    never.advance(0.001);
    EXPECT_GT(late.true_height(), never.true_height());
    never.advance(10);
    EXPECT_EQ(never.true_height(), lever.lowest);
}

TEST(Lever, EncoderCounts) {
    const LeverSettings lever;
    SimulatedLever mouse(lever, std::nullopt, 10.005);
    const double counts = mouse.height() / lever.encoder_step;
    EXPECT_NEAR(counts, std::round(counts), 1e-9);
    EXPECT_NEAR(mouse.height(), 10.005, lever.encoder_step / 2 + 1e-12);
}

}  // namespace
}  // namespace tactics::lever_test
