// SPDX-License-Identifier: Apache-2.0
// The finger's position: laws of dead reckoning, the paper's method, the required accuracy of the learning one, and false input.
#include "tactics/haptics/sensing/fusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tactics/error.h"
#include "tactics/haptics/simulated/pointing.h"
#include "tactics/measure/random.h"

namespace tactics::fusion_test {
namespace {

constexpr MouseGeometry kMouse{60, {10, -80}};
constexpr std::size_t kLearning = 4;  // strokes

std::unique_ptr<Fusion> fusion_of(bool learning) { return learning ? learning_fusion(kMouse) : paper_fusion(kMouse); }

Point rotated(Point p, double angle) {
    return {p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle)};
}

PointingError error_of(bool learning, const Pointing& pointing, const PointingCauses& causes, std::uint64_t seed) {
    return pointing_error(*fusion_of(learning), pointing, sense(pointing, kMouse, causes, seed), kLearning);
}

// A body that turns about a point: in its own axes each of its points has one velocity all the time, square to its way to that
// point.
TEST(Fusion, TurnsAboutAnyPointAreExact) {
    for (const bool learning : {false, true})
        for (const Point centre : {Point{0, 0}, Point{30, 0}, Point{10, -80}, Point{-200, 500}}) {
            const auto fusion = fusion_of(learning);
            constexpr int kSteps = 250;
            const double turn = 1.25 / kSteps;
            for (int i = 1; i <= kSteps; ++i)
                fusion->step({i / 1000.0, {turn * centre.y, turn * (-30 - centre.x)}, {turn * centre.y, turn * (30 - centre.x)}});
            const Point arm{kMouse.finger.x - centre.x, kMouse.finger.y - centre.y}, now = rotated(arm, 1.25);
            EXPECT_NEAR(fusion->pose().heading, 1.25, 1e-9);
            EXPECT_NEAR(fusion->pose().at.x, now.x - arm.x, 1e-6) << learning;
            EXPECT_NEAR(fusion->pose().at.y, now.y - arm.y, 1e-6) << learning;
        }
}

TEST(Fusion, PerfectSensorsGiveTheTruth) {
    const Pointing pointing = random_strokes(30, 1, 0, 0.2);
    const Sensed sensed = sense(pointing, kMouse, {}, 1);
    for (const bool learning : {false, true}) {
        const auto fusion = fusion_of(learning);
        double worst = 0, worst_heading = 0, worst_speed = 0;
        tell(*fusion, sensed, [&](double time) {
            if (time < 0.5) return;  // the first sample came before the first stroke
            const Pose truth = pointing.at(time), told = fusion->pose();
            worst = std::max(worst, distance(truth.at, told.at));
            worst_heading = std::max(worst_heading, std::abs(truth.heading - told.heading));
            worst_speed = std::max(worst_speed, distance(truth.velocity, told.velocity));
        });
        EXPECT_LT(worst, 0.02) << learning;
        EXPECT_LT(worst_heading, 1e-3) << learning;
        EXPECT_LT(worst_speed, 60) << learning;  // 10 m/s2 for the milliseconds that a speed takes to be known
        EXPECT_EQ(fusion->resets(), 0u);
    }
}

// The farthest that the first strokes are off once the hand has moved for half a second.
double off_in_first_strokes(double speed, const std::optional<LearnedPointing>& before, std::uint64_t seed) {
    const Pointing pointing = to_and_fro({0, 40}, {160, 40}, speed, 5);
    const auto fusion = learning_fusion(kMouse, before);
    double began = -1, farthest = 0;
    tell(*fusion, sense(pointing, kMouse, all_causes(), seed), [&](double time) {
        const Pose truth = pointing.at(time);
        if (distance({}, truth.velocity) < 1) return;
        if (began < 0) began = time;
        if (time - began > 0.5) farthest = std::max(farthest, distance(truth.at, fusion->pose().at));
    });
    return farthest;
}

TEST(Fusion, WhatWasLearnedLastTimeIsKnownInTheFirstStroke) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const auto last_time = learning_fusion(kMouse);
        EXPECT_FALSE(last_time->learned());
        tell(*last_time, sense(random_strokes(40, 50 + seed), kMouse, all_causes(), 70 + seed), [](double) {});
        const std::string kept = to_text(*last_time->learned());
        const LearnedPointing again = read_learned(kept, "kept");
        EXPECT_EQ(to_text(again), kept);
        for (const double speed : {100.0, 250.0, 400.0})
            EXPECT_LT(off_in_first_strokes(speed, again, seed), 2) << speed << " mm/s, seed " << seed;
        EXPECT_GT(off_in_first_strokes(250, std::nullopt, seed), off_in_first_strokes(250, again, seed));
    }
}

// Another mouse than the one that was learned: what was known is unlearned.
TEST(Fusion, WhatWasLearnedOfAnotherMouseIsUnlearned) {
    const auto last_time = learning_fusion(kMouse);
    PointingCauses other;
    other.scale = 0.8;
    other.delay = 0.08;
    tell(*last_time, sense(random_strokes(40, 3), kMouse, other, 4), [](double) {});
    const Pointing pointing = random_strokes(60, 5);
    const auto fusion = learning_fusion(kMouse, last_time->learned());
    const PointingError error = pointing_error(*fusion, pointing, sense(pointing, kMouse, all_causes(), 6), 30);
    EXPECT_LT(error.rms, 2);
}

TEST(Fusion, OnlyWhatCanHaveBeenLearnedIsRead) {
    const auto fusion = learning_fusion(kMouse);
    tell(*fusion, sense(random_strokes(10, 1), kMouse, all_causes(), 1), [](double) {});
    const std::string good = to_text(*fusion->learned());
    const auto refused = [](const std::string& text) {
        try {
            const LearnedPointing read = read_learned(text, "f");
            for (std::size_t i = 0; i < LearnedPointing::kValues; ++i)
                EXPECT_TRUE(std::isfinite(read.values[i]) && read.covariance[i][i] > 0);
            return false;
        } catch (const Error& error) {
            return std::string(error.what()).find("remove it") != std::string::npos;
        }
    };
    EXPECT_FALSE(refused(good));
    for (const char* text : {"", "tactics learned-pointing 2\n", "tactics learned-pointing 1\n0 1 nan\n"})
        EXPECT_TRUE(refused(text));
    for (std::size_t cut = 0; cut + 30 < good.size(); cut += 29) EXPECT_TRUE(refused(good.substr(0, cut))) << cut;
    for (std::size_t at = 25; at < good.size(); at += 7) {
        std::string odd = good;
        odd[at] = "9-x \n"[at % 5];
        refused(odd);
    }
}

TEST(Fusion, APlaceElsewhereOnTheTableChangesNothingElse) {
    const Pointing pointing = random_strokes(12, 2, 0, 0.2);
    const Sensed here = sense(pointing, kMouse, all_causes(), 2);
    Sensed there = here;
    for (OverlaySample& sample : there.samples) sample.at = {sample.at.x + 700, sample.at.y - 300};
    for (const bool learning : {false, true}) {
        std::vector<Point> places;
        const auto one = fusion_of(learning), other = fusion_of(learning);
        tell(*one, here, [&](double) { places.push_back(one->pose().at); });
        auto place = places.begin();
        double worst = 0;
        tell(*other, there, [&](double time) {
            if (time > 0.1) worst = std::max(worst, distance({place->x + 700, place->y - 300}, other->pose().at));
            ++place;
        });
        EXPECT_LT(worst, 1e-5) << learning;
    }
}

// The same strokes in another direction with the mouse held as before: what the sensors and the overlay say is turned.
TEST(Fusion, DirectionsAreAlike) {
    const Pointing pointing = random_strokes(12, 3);
    PointingCauses causes = all_causes();
    causes.heading_drift = 0;
    const Sensed here = sense(pointing, kMouse, causes, 3);
    Sensed there = here;
    for (OverlaySample& sample : there.samples) sample.at = rotated(sample.at, 1.1);
    for (OpticalStep& step : there.steps) step.first = step.second = rotated(step.first, 1.1);
    for (const bool learning : {false, true}) {
        std::vector<Point> places;
        const auto one = fusion_of(learning), other = fusion_of(learning);
        tell(*one, here, [&](double) { places.push_back(rotated(one->pose().at, 1.1)); });
        auto place = places.begin();
        double worst = 0;
        tell(*other, there, [&](double time) {
            if (time > 0.1) worst = std::max(worst, distance(*place, other->pose().at));
            ++place;
        });
        // The learning one allows for sensors that count unlike, which show in one direction only.
        EXPECT_LT(worst, learning ? 2.0 : 1e-9);
    }
}

// The paper (V.A, figures 8 and 9): right at 100 mm/s, some 20 mm too far at 250.
TEST(PaperFusion, OvershootsAsTheDelayIsWrong) {
    const Pointing slow = straight_strokes(12, 100, 2500, 5), fast = straight_strokes(12, 250, 2500, 5);
    EXPECT_LT(error_of(false, fast, {}, 5).overshoot, 0.01);
    EXPECT_LT(error_of(false, fast, {}, 5).rms, 0.01);
    PointingCauses late;
    late.delay = 0.07;
    EXPECT_NEAR(error_of(false, slow, late, 5).overshoot, 8, 0.2);
    EXPECT_NEAR(error_of(false, fast, late, 5).overshoot, 19.5, 0.5);
    PointingCauses accelerated;
    accelerated.acceleration = 1.8;
    EXPECT_LT(error_of(false, slow, accelerated, 5).overshoot, 0.5);
    EXPECT_GT(error_of(false, fast, accelerated, 5).overshoot, 15);
    EXPECT_GT(error_of(false, fast, all_causes(), 5).rms, 15);
}

class OnSeeds : public ::testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(LearningFusion, OnSeeds, ::testing::Values(70001, 70002, 70003, 70004));

TEST_P(OnSeeds, AllCausesTogether) {
    const PointingError slow = error_of(true, straight_strokes(16, 100, 2500, GetParam()), all_causes(), GetParam());
    EXPECT_LE(slow.overshoot, 0.5);
    EXPECT_LE(slow.rms, 0.6);
    const PointingError fast = error_of(true, straight_strokes(16, 250, 2500, GetParam()), all_causes(), GetParam());
    EXPECT_LE(fast.overshoot, 0.6);
    EXPECT_LE(fast.worst_overshoot, 1);
    EXPECT_LE(fast.rms, 0.8);
    const PointingError sudden = error_of(true, straight_strokes(16, 250, 10000, GetParam()), all_causes(), GetParam());
    EXPECT_LE(sudden.overshoot, 1);
    EXPECT_LE(sudden.rms, 1.2);
    const PointingError random = error_of(true, random_strokes(50, GetParam()), all_causes(), GetParam());
    EXPECT_LE(random.rms, 1.5);
    EXPECT_LE(random.most_of_it, 3.5);
    const PointingError turning = error_of(true, random_strokes(50, GetParam(), 0.3, 0.2), all_causes(), GetParam());
    EXPECT_LE(turning.rms, 2);
}

// The delay is 0.15 s up to 100 mm/s and 0.07 s from 250 on, by the speed when the sample is told or when the finger was there.
TEST_P(OnSeeds, AnOverlayThatIsQuickerAtSpeed) {
    for (const double judged : {0.0, 0.5, 1.0}) {
        PointingCauses causes;
        causes.quicker = 0.08;
        causes.judged = judged;
        const PointingError sudden = error_of(true, straight_strokes(16, 250, 10000, GetParam()), causes, GetParam());
        EXPECT_LE(sudden.overshoot, 0.5) << judged;
        EXPECT_LE(sudden.rms, 0.5) << judged;
        EXPECT_GT(error_of(false, straight_strokes(16, 250, 10000, GetParam()), causes, GetParam()).overshoot, 15) << judged;
        PointingCauses all = all_causes();
        all.quicker = 0.08;
        all.judged = judged;
        EXPECT_LE(error_of(true, straight_strokes(16, 250, 2500, GetParam()), all, GetParam()).overshoot, 1) << judged;
    }
}

// A hand that rests; then the overlay tells of a place 100 mm away, as after the mouse was lifted.
TEST(LearningFusion, AJumpIsNoticedAndMended) {
    const Pointing pointing = straight_strokes(8, 250, 2500, 6);
    const Sensed sensed = sense(pointing, kMouse, all_causes(), 6);
    const auto fusion = fusion_of(true);
    tell(*fusion, sensed, [](double) {});
    ASSERT_EQ(fusion->resets(), 0u);
    const Point lifted{pointing.at(pointing.end()).at.x + 100, pointing.at(pointing.end()).at.y};
    double time = pointing.end();
    int samples = 0;
    for (; samples < 20 && fusion->resets() == 0; ++samples) fusion->overlay({time += 1.0 / 60, lifted});
    EXPECT_EQ(samples, 4);
    EXPECT_EQ(fusion->resets(), 1u);
    EXPECT_LT(distance(fusion->pose().at, lifted), 2);
}

TEST(LearningFusion, OneWrongSampleChangesLittle) {
    const Pointing pointing = straight_strokes(8, 250, 2500, 7);
    Sensed sensed = sense(pointing, kMouse, all_causes(), 7);
    for (std::size_t i = 100; i < sensed.samples.size(); i += 50) sensed.samples[i].at.y += 100;
    const PointingError error = pointing_error(*fusion_of(true), pointing, sensed, kLearning);
    EXPECT_EQ(error.resets, 0u);
    EXPECT_LE(error.rms, 1.2);
}

TEST(LearningFusion, ASurfaceThatChangesIsLearnedAnew) {
    const Pointing pointing = random_strokes(40, 8);
    Sensed sensed = sense(pointing, kMouse, all_causes(), 8);
    for (std::size_t i = sensed.steps.size() / 3; i < sensed.steps.size(); ++i)
        for (Point* p : {&sensed.steps[i].first, &sensed.steps[i].second}) *p = {p->x * 0.92, p->y * 0.92};
    EXPECT_LE(pointing_error(*fusion_of(true), pointing, sensed, 25).rms, 2);
}

TEST(Fusion, SensorsAlone) {
    const Pointing pointing = random_strokes(5, 9);
    Sensed sensed = sense(pointing, kMouse, {}, 9);
    sensed.samples.clear();
    const Point begin = pointing.at(0).at, end = pointing.at(pointing.end()).at;
    for (const bool learning : {false, true}) {
        const auto fusion = fusion_of(learning);
        tell(*fusion, sensed, [](double) {});
        EXPECT_NEAR(fusion->pose().at.x, end.x - begin.x, 0.01);
        EXPECT_NEAR(fusion->pose().at.y, end.y - begin.y, 0.01);
    }
}

TEST(Fusion, OverlayAlone) {
    const Sensed sensed = sense(random_strokes(5, 10), kMouse, all_causes(), 10);
    for (const bool learning : {false, true}) {
        const auto fusion = fusion_of(learning);
        for (const OverlaySample& sample : sensed.samples) {
            fusion->overlay(sample);
            ASSERT_LT(distance(fusion->pose().at, sample.at), 0.1);
        }
        EXPECT_EQ(fusion->resets(), 0u);
    }
}

TEST(Fusion, WithoutSensorsForAWhileItHoldsOnToTheOverlay) {
    const Pointing pointing = random_strokes(20, 11);
    Sensed sensed = sense(pointing, kMouse, all_causes(), 11);
    const double from = pointing.end() / 2, to = from + 3;
    std::erase_if(sensed.steps, [&](const OpticalStep& step) { return step.time > from && step.time < to; });
    for (const bool learning : {false, true}) {
        const auto fusion = fusion_of(learning);
        double worst = 0;
        tell(*fusion, sensed, [&](double time) {
            if (time > to + 1) worst = std::max(worst, distance(fusion->pose().at, pointing.at(time).at));
        });
        EXPECT_LT(worst, learning ? 8 : 80);
    }
}

bool is_finite(const Pose& pose) {
    return std::isfinite(pose.at.x) && std::isfinite(pose.at.y) && std::isfinite(pose.heading) &&
           std::isfinite(pose.velocity.x) && std::isfinite(pose.velocity.y);
}

// Lies of every kind among the truth, then the truth alone: it is found again.
TEST(Fusion, HostileInput) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinite = std::numeric_limits<double>::infinity();
    const double lies[] = {kNan, kInfinite, -kInfinite, 1e308, -1e308, 1e300, 1e11, -1e11, 1e5, 0, 1e-308, -5, 1e13};
    const Pointing pointing = random_strokes(40, 12);
    const Sensed sensed = sense(pointing, kMouse, all_causes(), 12);
    const double peace = pointing.end() / 2;
    for (const bool learning : {false, true}) {
        const auto fusion = fusion_of(learning);
        RandomNumbers chance(12);
        const auto lie = [&] { return lies[chance.below(std::size(lies))]; };
        double squares = 0;
        int count = 0;
        tell(*fusion, sensed, [&](double time) {
            if (time < peace) {
                if (chance.below(20) == 0) fusion->step({chance.below(2) == 0 ? lie() : time, {lie(), lie()}, {lie(), lie()}});
                if (chance.below(200) == 0) fusion->overlay({chance.below(2) == 0 ? lie() : time, {lie(), lie()}});
            }
            const Pose pose = fusion->pose();
            ASSERT_TRUE(is_finite(pose)) << time;
            if (time < peace + 5) return;
            squares += std::pow(distance(pose.at, pointing.at(time).at), 2);
            ++count;
        });
        if (learning) {
            EXPECT_LT(std::sqrt(squares / count), 3);
        }
    }
}

TEST(Fusion, GeometryThatCannotBe) {
    for (const double apart : {0.0, std::numeric_limits<double>::quiet_NaN(), 1e300})
        for (const bool learning : {false, true}) {
            const MouseGeometry geometry{apart, {std::numeric_limits<double>::infinity(), 0}};
            const auto fusion =
                learning ? learning_fusion(geometry) : paper_fusion(geometry, std::numeric_limits<double>::quiet_NaN());
            fusion->overlay({0, {5, 5}});
            fusion->step({0.1, {1, 0}, {1, 0.1}});
            fusion->overlay({0.3, {6, 5}});
            EXPECT_TRUE(is_finite(fusion->pose()));
        }
}

}  // namespace
}  // namespace tactics::fusion_test
