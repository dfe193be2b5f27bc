// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/stability.h"

#include <gtest/gtest.h>

namespace tactics::stability_test {
namespace {

LeverSettings lever_of(double mass_g, double delay) {
    LeverSettings lever;
    lever.mass_g = mass_g;
    lever.delay = delay;
    return lever;
}

LeverSettings lever_without_friction() {
    LeverSettings lever;
    lever.friction = 0;
    return lever;
}

double largest(double damping, const LeverSettings& lever, int finger) {
    if (finger < 0) return largest_stiffness(damping, DampingSign::corrected, lever, {});
    return largest_stiffness(damping, DampingSign::corrected, lever,
                             std::span(&kFingers[static_cast<std::size_t>(finger)].finger, 1));
}

// Figures of another program for the same model.
TEST(Stability, IsThatOfAnotherSimulation) {
    struct Entry {
        double mass_g, delay;
        int finger;
        double damping, stiffness;
    };
    for (const Entry& entry : {Entry{30, 0, 1, 0, 7.4},
                               {30, 0, 1, 5, 15.8},
                               {30, 0.001, 1, 0, 1.6},
                               {30, 0.002, 1, 2, 1.7},
                               {30, 0, 0, 0.5, 7.4},
                               {30, 0.001, 2, 8, 5.5},
                               {30, 0, -1, 1, 6.6},
                               {30, 0.001, -1, 2, 2.2},
                               {100, 0, -1, 2, 5.9},
                               {100, 0.001, -1, 8, 4.9}}) {
        const double found = largest(entry.damping, lever_of(entry.mass_g, entry.delay), entry.finger);
        EXPECT_NEAR(found, entry.stiffness, 0.25 * entry.stiffness)
            << entry.mass_g << " g, delay " << entry.delay << ", finger " << entry.finger << ", " << entry.damping << " N s/m";
    }
}

TEST(Stability, GrowsWithTheRateOfTheLoop) {
    double before = 0;
    for (const double rate : {500.0, 1000.0, 2000.0, 4000.0}) {
        LeverSettings lever;
        lever.rate_hz = rate;
        const double now = largest(0, lever, 1);
        EXPECT_GT(now, 1.7 * before) << rate;
        before = now;
    }
}

TEST(Stability, ThePrintedSignFailsWhereTheCorrectedHolds) {
    const FingerSettings nominal = kFingers[1].finger;
    const std::span fingers(&nominal, 1);
    for (const double stiffness : {0.5, 1.0, 5.0}) {
        EXPECT_TRUE(comes_to_rest({stiffness, 2, DampingSign::corrected}, {}, fingers)) << stiffness;
        EXPECT_FALSE(comes_to_rest({stiffness, 2, DampingSign::as_printed}, {}, fingers)) << stiffness;
    }
    const double none = largest_stiffness(0, DampingSign::as_printed, {}, fingers),
                 some = largest_stiffness(1, DampingSign::as_printed, {}, fingers);
    EXPECT_LT(some, 0.8 * none);
    EXPECT_GT(some, 0);
}

TEST(Stability, SmallDeviationsShrinkWhereAllIsWellAndGrowFarOutside) {
    const FingerSettings nominal = kFingers[1].finger;
    EXPECT_LT(growth({0.5, 2}, {}, &nominal), 1 + 1e-9);
    EXPECT_GT(growth({40, 2}, {}, &nominal), 1.05);
    EXPECT_LT(growth({1, 1}, lever_of(30, 0), &nominal), growth({1, 1}, lever_of(30, 0.003), &nominal));
    // A free lever with a damper of b, a spring K and a period T: b > K T / 2 (J. E. Colgate, G. Schenkel 1997), here 0.6 N/mm.
    EXPECT_LT(growth({0.55, 0}, {}, nullptr), 1 + 1e-6);
    EXPECT_GT(growth({0.65, 0}, {}, nullptr), 1);
}

TEST(Stability, TheNearestIsStableAndSoSaid) {
    const std::vector<FingerSettings> all = {kFingers[0].finger, kFingers[1].finger, kFingers[2].finger};
    const StableCheck good = check_stable({1, 1}, {}, all);
    EXPECT_TRUE(good.stable);
    EXPECT_EQ(good.reason.english(), "");
    EXPECT_EQ(good.stiffness, 1);
    // A lever that hardly moves, while its force jumps at every tick, is not at rest.
    for (const double damping : {45.0, 60.0}) {
        const StableCheck trembles = check_stable({1, damping}, {}, all);
        EXPECT_FALSE(trembles.stable) << damping;
        EXPECT_NE(trembles.reason.english().find("trembles from tick to tick"), std::string::npos) << trembles.reason.english();
    }
    for (const double delay : {0.0, 0.001, 0.003})
        for (const ForceLaw& law : {ForceLaw{40, 1}, ForceLaw{14, 100}, ForceLaw{5, 2, DampingSign::as_printed}}) {
            const LeverSettings lever = lever_of(30, delay);
            const StableCheck bad = check_stable(law, lever, all);
            ASSERT_FALSE(bad.stable) << law.stiffness << " " << delay;
            EXPECT_NE(bad.reason.english().find("swings on by"), std::string::npos) << bad.reason.english();
            ASSERT_GT(bad.stiffness, 0) << law.stiffness << " " << delay;
            EXPECT_LE(bad.stiffness, law.stiffness);
            EXPECT_TRUE(comes_to_rest({bad.stiffness, bad.damping_ns_per_m}, lever, all)) << bad.reason.english();
        }
    EXPECT_FALSE(check_stable({0, 1}, {}, all).stable);
    EXPECT_FALSE(check_stable({1, -1}, {}, all).stable);
}

// A surface that is no longer touched, and a motor without the assumed friction.
TEST(Stability, WhatIsOfferedComesToRestWithoutFingerAndFriction) {
    const std::vector<FingerSettings> all = {kFingers[0].finger, kFingers[1].finger, kFingers[2].finger};
    LeverSettings lever = lever_of(100, 0.0015);
    EXPECT_FALSE(comes_to_rest({1, 1}, lever, {}));
    const StableCheck check = check_stable({1, 1}, lever, all);
    ASSERT_FALSE(check.stable);
    EXPECT_EQ(check.stiffness, 1) << "as stiff as was asked for";
    EXPECT_GT(check.damping_ns_per_m, 1);
    for (const double friction : {0.0, 0.01, 0.3}) {
        lever.friction = friction;
        EXPECT_TRUE(comes_to_rest({check.stiffness, check.damping_ns_per_m}, lever, {})) << friction;
        EXPECT_TRUE(comes_to_rest({check.stiffness, check.damping_ns_per_m}, lever, all)) << friction;
    }
    const StableCheck light = check_stable({1, 1}, lever_of(30, 0.0015), all);
    EXPECT_NE(light.reason.english().find("once the finger is lifted"), std::string::npos) << light.reason.english();
    // No damping that can be offered bears it: softer.
    const StableCheck hard = check_stable({30, 1}, lever, all);
    EXPECT_LT(hard.stiffness, 10);
    EXPECT_TRUE(comes_to_rest({hard.stiffness, hard.damping_ns_per_m}, lever, {}));
}

TEST(Stability, TheRegionIsABorder) {
    const FingerSettings nominal = kFingers[1].finger;
    const auto border = stable_region(8, 5, DampingSign::corrected, {}, std::span(&nominal, 1));
    ASSERT_EQ(border.size(), 5u);
    EXPECT_EQ(border.front().damping_ns_per_m, 0);
    EXPECT_EQ(border.back().damping_ns_per_m, 8);
    for (std::size_t i = 1; i < border.size(); ++i) EXPECT_GT(border[i].stiffness, border[i - 1].stiffness);
    for (const StablePoint& point : border)
        EXPECT_FALSE(comes_to_rest({point.stiffness * 1.3, point.damping_ns_per_m}, lever_without_friction(), {}))
            << point.damping_ns_per_m;
}

}  // namespace
}  // namespace tactics::stability_test
