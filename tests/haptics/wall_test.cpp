// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/wall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "tests/haptics/wall_trials.h"

namespace tactics::wall_test {
namespace {

WallSettings settings_of(WallMethod method, const LeverSettings& lever, const FingerSettings& finger) {
    WallSettings settings;
    settings.method = method;
    settings.lever = lever;
    settings.lever.delay = 0.001;
    settings.law.damping_ns_per_m = 0.5;
    settings.finger = finger;
    return settings;
}

TEST(Walls, AreKnownByName) {
    std::set<WallMethod> seen;
    for (const NamedWall& wall : wall_methods()) {
        EXPECT_EQ(wall_method(wall.name), wall.method);
        EXPECT_TRUE(seen.insert(wall.method).second) << wall.name;
    }
    EXPECT_EQ(seen.size(), 6u);
    EXPECT_FALSE(wall_method("brick"));
}

// An ideal lever follows its reference with the given forces, none of which exceeds the motor.
TEST(Governor, AsksForNothingThatTheMotorCannotDo) {
    for (const NamedLever& lever : kLevers)
        for (const NamedFinger& finger : kFingers) {
            LeverSettings ideal = lever.lever;
            ideal.friction = ideal.encoder_step = ideal.delay = 0;
            Governor governor(lever.lever, finger.finger, 1);
            governor.begin(10);
            SimulatedLever mouse(ideal, finger.finger, 10 - governor.hang());
            double farthest = 0;
            for (int tick = 0; tick < 300; ++tick) {
                governor.follow(tick < 20 ? 10 : 50, 0.001);
                EXPECT_LE(std::abs(governor.force()), ideal.most_force);
                if (tick >= 20 && !governor.under_way()) break;
                mouse.push(governor.force());
                mouse.advance(0.001);
                farthest = std::max(farthest, std::abs(mouse.true_height() + governor.hang() - governor.height()));
            }
            EXPECT_LT(farthest, 1) << lever.name << " " << finger.name;
            EXPECT_NEAR(governor.height(), 50, 0.5) << lever.name << " " << finger.name;
        }
}

TEST(Governor, IsTheSurfaceWhereTheMotorCanFollow) {
    Governor governor({}, {}, 1);
    governor.begin(10);
    for (int tick = 0; tick < 1000; ++tick) {
        const double hill = 10 + 2 * (1 - std::cos(tick * 0.01));  // 20 mm/s at most
        governor.follow(hill, 0.001);
        ASSERT_NEAR(governor.height(), hill, 1e-9);
        ASSERT_EQ(governor.lead(), 0);
    }
}

// The line that walls are measured by.
TEST(Walls, LookAheadHoldsForEveryLeverAndFinger) {
    for (const NamedLever& lever : kLevers)
        for (const NamedFinger& finger : kFingers) {
            const WallSettings settings = settings_of(WallMethod::look_ahead, lever.lever, finger.finger);
            for (const double speed : {25.0, 40.0, 50.0, 75.0, 100.0}) {
                const Crossing crossing = cross(settings, finger.finger, speed);
                EXPECT_LE(crossing.overshoot, 1) << lever.name << " " << finger.name << " " << speed;
                EXPECT_LE(std::abs(crossing.shift), 0.5) << lever.name << " " << finger.name << " " << speed;
                EXPECT_LE(highest_false_bump(settings, finger.finger, speed, settings.nearest_stop), 1)
                    << lever.name << " " << finger.name << " " << speed;
            }
        }
}

// The walls of height maps are as wide as their samples are apart; and a real mouse feels forces later.
TEST(Walls, LookAheadHoldsInHeightMapsAndOnRealMice) {
    for (const NamedLever& lever : kLevers)
        for (const NamedFinger& finger : kFingers)
            for (const double wide : {0.1, 0.5, 1.0, 1.5})
                for (const double speed : {25.0, 100.0}) {
                    WallSettings settings = settings_of(WallMethod::look_ahead, lever.lever, finger.finger);
                    const Crossing crossing = cross(settings, finger.finger, speed, wide);
                    EXPECT_LE(crossing.overshoot, 1) << lever.name << " " << finger.name << " " << speed << " " << wide;
                    EXPECT_LE(std::abs(crossing.shift), 0.5) << lever.name << " " << finger.name << " " << speed << " " << wide;
                    EXPECT_LE(highest_false_bump(settings, finger.finger, speed, settings.nearest_stop, wide), 1)
                        << lever.name << " " << finger.name << " " << speed << " " << wide;
                    settings.lever.delay = 0.0015;
                    settings.law.damping_ns_per_m = 1;
                    const Crossing late = cross(settings, finger.finger, speed, wide);
                    EXPECT_LE(late.overshoot, 1) << lever.name << " " << finger.name << " " << speed << " " << wide;
                    EXPECT_LE(std::abs(late.shift), 0.5) << lever.name << " " << finger.name << " " << speed << " " << wide;
                }
}

// A hand that turns along a wall is not lifted onto it, as long as it turns less sharply (2000 mm/s2) than a hand brakes.
TEST(Walls, AHandThatTurnsBeforeAWallFeelsNothing) {
    for (const NamedLever& lever : kLevers)
        for (const NamedFinger& finger : kFingers)
            for (const double speed : {50.0, 100.0, 200.0}) {
                const WallSettings settings = settings_of(WallMethod::look_ahead, lever.lever, finger.finger);
                EXPECT_LE(turning_bump(settings, finger.finger, speed, std::max(1.0, speed * speed / 2000), 1), 1)
                    << lever.name << " " << finger.name << " " << speed;
            }
}

// Nearer to the wall a light lever is still quick enough; a heavy one rises, no more than 2 mm higher than no method betters, or
// it has the edge later.
TEST(Walls, StopsNearerToTheWallAreForALightLever) {
    for (const NamedFinger& finger : kFingers)
        for (const double speed : {25.0, 50.0, 100.0}) {
            EXPECT_LE(highest_false_bump(settings_of(WallMethod::look_ahead, kLevers[0].lever, finger.finger), finger.finger,
                                         speed, 0.1),
                      1.1)
                << finger.name << " " << speed;
            const WallSettings heavy = settings_of(WallMethod::look_ahead, kLevers[1].lever, finger.finger);
            for (const double before : {0.1, 0.5})
                EXPECT_LE(false_bump(heavy, finger.finger, speed, before),
                          least_false_bump(heavy, finger.finger, speed, before, heavy.late) + 2)
                    << finger.name << " " << speed << " " << before;
            WallSettings late = heavy;
            late.nearest_stop = 0.1;
            EXPECT_LE(highest_false_bump(late, finger.finger, speed, 0.1), 1) << finger.name << " " << speed;
            EXPECT_LE(cross(late, finger.finger, speed).shift, 1.3) << finger.name << " " << speed;
        }
}

TEST(Walls, ThePlainWallAndThePapersStepsFlyPast) {
    const FingerSettings soft = kFingers[0].finger;
    const LeverSettings light = kLevers[0].lever;
    EXPECT_GT(cross(settings_of(WallMethod::raw, light, soft), soft, 50).overshoot, 11);
    const double steps_slow = cross(settings_of(WallMethod::steps, light, soft), soft, 25).overshoot;
    EXPECT_GT(steps_slow, 3);
    EXPECT_LT(steps_slow, 8);
    EXPECT_GT(cross(settings_of(WallMethod::steps, light, soft), soft, 100).overshoot, 11);
    EXPECT_LE(cross(settings_of(WallMethod::governor, light, soft), soft, 100).overshoot, 1);
    EXPECT_GT(cross(settings_of(WallMethod::governor, light, soft), soft, 100).shift, 1.5);
}

TEST(Walls, AFingerThatIsNotKnownDoesNotFlyPast) {
    WallSettings settings;
    settings.lever.delay = 0.001;
    for (const NamedFinger& finger : kFingers) EXPECT_LE(cross(settings, finger.finger, 75).overshoot, 1) << finger.name;
}

double ramp(const void*, Point at) noexcept { return at.x < 0 ? 8 : 48; }

TEST(Walls, StepsAreTwentyMillimetresAMillimetre) {
    WallSettings settings;
    settings.method = WallMethod::steps;
    Wall wall(settings);
    const auto at = [&](double x) { return wall.reference({nullptr, ramp}, {x, 0}, {100, 0}, 0.001); };
    EXPECT_EQ(at(-0.1), 8);
    EXPECT_EQ(at(0), 28);
    EXPECT_EQ(at(0.9), 28);
    EXPECT_EQ(at(1.1), 48);
    EXPECT_EQ(at(5), 48);
}

TEST(Walls, SlopeBeginsAtTheEdge) {
    WallSettings settings;
    settings.method = WallMethod::slope;
    Wall wall(settings);
    double last = 8;
    for (int tick = -100; tick < 2000; ++tick) {
        const double x = tick * 0.02;  // 20 mm/s: 160 mm/s up
        const double now = wall.reference({nullptr, ramp}, {x, 0}, {20, 0}, 0.001);
        if (x < 0) {
            ASSERT_EQ(now, 8);
        }
        if (x > 1 && x < 4.5) {
            ASSERT_NEAR(now, 8 + settings.slope * x, 3) << x;
        }
        last = now;
    }
    EXPECT_NEAR(last, 48, 0.1);
}

double hole(const void*, Point at) noexcept { return at.x > 1 && at.x < 2 ? std::numeric_limits<double>::quiet_NaN() : 10; }

TEST(Walls, BridgeWhatIsNoNumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const NamedWall& method : wall_methods()) {
        WallSettings settings;
        settings.method = method.method;
        Wall wall(settings);
        for (int tick = 0; tick < 400; ++tick) {
            const double reference = wall.reference({nullptr, hole}, {tick * 0.01, 0}, {tick % 7 == 0 ? nan : 10, 0}, 0.001);
            ASSERT_NEAR(reference, 10, 1e-9) << method.name << " " << tick;
            ASSERT_TRUE(std::isfinite(wall_force(settings, wall, reference, 9, 9, 0.001)));
        }
        EXPECT_NEAR(wall.reference({nullptr, hole}, {nan, 0}, {10, 0}, 0.001), 10, 1e-9);
        EXPECT_NEAR(wall.reference({nullptr, hole}, {3, 0}, {10, 0}, -1), 10, 1e-9);
    }
}

}  // namespace
}  // namespace tactics::wall_test
