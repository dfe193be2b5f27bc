// SPDX-License-Identifier: Apache-2.0
// The simulated arm, its file, where a scene is mounted in it, and what it bears.
#include "tactics/haptics/simulated/arm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "tactics/error.h"
#include "tactics/haptics/devices/mounting.h"
#include "tactics/haptics/devices/simulated_arm.h"
#include "tactics/haptics/scenes/stability.h"

namespace tactics::arm_test {
namespace {

TEST(Arm, ObeysNewton) {
    ArmSettings arm = kArms[0].arm;
    arm.friction = arm.damping_ns_per_m = 0;
    SimulatedArm free(arm, std::nullopt, {});
    free.push({0.45, 0, 0});
    free.advance(0.05, {});
    // 0.45 N on 45 g: 10 m/s2, 12.5 mm in 50 ms.
    EXPECT_NEAR(free.place().x, 12.5, 0.05);
    EXPECT_NEAR(free.velocity().x, 500, 1e-6);
    EXPECT_EQ(free.place().y, 0);
}

TEST(Arm, FrictionHoldsWhatItCanAndAFingerFollowsItsHand) {
    SimulatedArm held(kArms[0].arm, std::nullopt, {});
    held.push({0.15, 0.15, 0.15});  // 0.2598 N together, below 0.26 N
    held.advance(0.5, {});
    EXPECT_EQ(held.place(), Point3{});
    SimulatedArm moved(kArms[0].arm, kFingers[1].finger, {});
    for (int i = 0; i < 1000; ++i) moved.advance(0.001, {20, -10, 5});
    // Within what friction holds against: 0.26 N at 0.3 N/mm.
    EXPECT_LT(length_of(moved.place() - Point3{20, -10, 5}), 0.26 / 0.3 + 0.01);
}

TEST(Arm, ForcesAreCutAndComeLate) {
    ArmSettings arm = kArms[0].arm;
    arm.delay = 0.01;
    SimulatedArm late(arm, std::nullopt, {});
    late.push({100, 0, 0});
    late.advance(0.0099, {});
    EXPECT_EQ(late.place(), Point3{});
    late.advance(0.01, {});
    EXPECT_GT(late.place().x, 0);
    // 3.3 N less 0.26 N on 45 g, no more.
    EXPECT_LT(late.place().x, 0.5 * 3.04 / 0.045 * 0.01 * 0.01 * 1000 + 0.01);
    SimulatedArm odd(arm, std::nullopt, {});
    odd.push({std::nan(""), 1, INFINITY});
    odd.advance(0.5, {});
    EXPECT_EQ(odd.place(), Point3{});
}

TEST(Arm, StopsAtItsWorkspaceAndTellsInSteps) {
    ArmSettings arm = kArms[0].arm;
    SimulatedArm stopped(arm, std::nullopt, {});
    stopped.push({3, 0, 0});
    stopped.advance(1, {});
    EXPECT_EQ(stopped.place().x, 80);
    EXPECT_NEAR(std::remainder(stopped.told().x, 0.055), 0, 1e-9);
    arm.noise = 0.2;
    SimulatedArm noisy(arm, std::nullopt, {1, 2, 3});
    double sum = 0, squares = 0;
    for (int i = 0; i < 4000; ++i) {
        const double off = noisy.told().y - 2;
        sum += off;
        squares += off * off;
    }
    EXPECT_NEAR(sum / 4000, 0, 0.02);
    EXPECT_NEAR(std::sqrt(squares / 4000), 0.2, 0.02);
}

TEST(ArmFile, ReadsWhatItWritesAndSaysWhatIsWrong) {
    ArmFile file{kArms[2].arm, kFingers[2].finger, true};
    file.arm.delay = 0.0015;
    file.arm.noise = 0.03;
    const ArmFile back = read_arm(to_text(file), "arm.txt");
    EXPECT_EQ(back.arm, file.arm);
    EXPECT_TRUE(back.lifted);
    EXPECT_EQ(read_arm("arm = desktop\narm.delay = 0.001 s\n", "a").arm.resolution, 0.023);
    const auto message = [](const char* text) -> std::string {
        try {
            read_arm(text, "arm.txt");
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message("arm = omny"), "arm.txt:1: no arm is called \"omny\" (omni?)");
    EXPECT_EQ(message("arm.forze = 3 N"), "arm.txt:1: an arm has no \"arm.forze\" (arm.force?)");
    EXPECT_EQ(message("arm.force = 50 N"), "arm.txt:1: arm.force is out of range (give 0.1 to 8 N)");
}

TEST(Mounting, TurnsPlacesAndForcesTheSameWay) {
    std::mt19937 random(1);
    std::normal_distribution<double> any(0, 30);
    for (int i = 0; i < 200; ++i) {
        const ScenePlane plane{any(random), any(random), any(random), any(random)};
        const MountedField field = mount(plane, {160, 120, 70}, 1.5, 8);
        if (field.width == 0) continue;
        const Mounting& m = field.mounting;
        EXPECT_NEAR(dot(m.right, m.down), 0, 1e-12);
        EXPECT_NEAR(dot(m.right, m.out), 0, 1e-12);
        EXPECT_NEAR(length_of(m.down), 1, 1e-12);
        const Point3 at{any(random), any(random), any(random)};
        EXPECT_LT(length_of(m.to_scene(m.to_device(at)) - at), 1e-9);
        // Work is the same in both: force times way.
        const Point3 force{any(random), any(random), any(random)}, way{1, -2, 3};
        EXPECT_NEAR(dot(m.turned(force), m.to_device(at + way) - m.to_device(at)), dot(force, way), 1e-9);
        // All of the field is in the plane and in the workspace.
        for (const Point3 corner :
             {Point3{0, 0, 0}, Point3{field.width, 0, 0}, Point3{0, field.height, 0}, Point3{field.width, field.height, 0}}) {
            const Point3 p = m.to_device(corner);
            EXPECT_NEAR(plane.a * p.x + plane.b * p.y + plane.c * p.z + plane.d, 0, 1e-6);
            EXPECT_LE(std::abs(p.x), 72 + 1e-9);
            EXPECT_LE(std::abs(p.y), 52 + 1e-9);
            EXPECT_LE(std::abs(p.z), 27 + 1e-9);
        }
    }
    const Mounting upright = mount(kUpright, {160, 120, 70}, 1.5, 8).mounting,
                   flat = mount(kFlat, {160, 120, 70}, 1.5, 8).mounting;
    EXPECT_EQ(upright.turned({0, -1, 0}), (Point3{0, 1, 0}));  // up in the plot is up
    EXPECT_EQ(upright.turned({0, 0, 1}), (Point3{0, 0, 1}));   // out of it is towards the person
    EXPECT_EQ(flat.turned({0, -1, 0}), (Point3{0, 0, -1}));    // up in the plot is away from the person
    EXPECT_EQ(flat.turned({0, 0, 1}), (Point3{0, 1, 0}));
    EXPECT_EQ(mount({0, 0, 1, 500}, {160, 120, 70}, 1.5, 8).width, 0);
}

// What is called borne comes to rest in a simulation, with a finger and with none, however it is thrown; what is refused as
// swinging up does not without friction.
double swing_after(const ForceLaw& law, ArmSettings arm, const std::optional<FingerSettings>& finger) {
    arm.friction = 0;
    arm.resolution = 0;
    SimulatedArm device(arm, finger, {0, 0, 3});
    Point3 before = device.place();
    double most = 0;
    for (int i = 0; i < 3000; ++i) {
        const Point3 at = device.place(), speed = 1000 * (at - before);
        device.push(-law.stiffness * at - law.damping_ns_per_m / 1000 * speed);
        before = at;
        device.advance(0.001, {});
        if (i > 2500) most = std::max(most, length_of(device.place()));
    }
    return most;
}

TEST(ArmStability, WhatIsBorneComesToRestAndWhatIsRefusedDoesNot) {
    std::vector<FingerSettings> fingers;
    for (const NamedFinger& one : kFingers) fingers.push_back(one.finger);
    for (const NamedArm& named : kArms)
        for (const double delay : {0.0, 0.001, 0.002})
            for (const double stiffness : {0.2, 0.5, 1.0, 3.0, 9.0})
                for (const double damping : {0.0, 1.0, 3.0}) {
                    ArmSettings arm = named.arm;
                    arm.delay = delay;
                    const ForceLaw law{stiffness, damping};
                    const StableCheck check = check_arm(law, arm, fingers);
                    const std::string where = std::string(named.name) + " " + std::to_string(delay) + " " +
                                              std::to_string(stiffness) + " " + std::to_string(damping);
                    double left = swing_after(law, arm, std::nullopt);
                    for (const FingerSettings& finger : fingers) left = std::max(left, swing_after(law, arm, finger));
                    if (check.stable) {
                        EXPECT_LE(stiffness, arm.most_stiffness);
                        EXPECT_LT(left, 3.1) << where;
                    } else if (check.reason.english().find("swings up") != std::string::npos) {
                        EXPECT_GT(left, 0.05) << where;
                    }
                    if (check.stiffness > 0) {
                        EXPECT_LE(check.stiffness, arm.most_stiffness + 1e-9) << where;
                        const ForceLaw offered{check.stiffness, check.damping_ns_per_m};
                        EXPECT_TRUE(check_arm(offered, arm, fingers).stable) << where;
                    }
                }
}

}  // namespace
}  // namespace tactics::arm_test
