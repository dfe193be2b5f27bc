// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/guidance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/haptics/allocations.h"

namespace tactics::guidance_test {
namespace {

constexpr double kTick = 0.001, kResolution = 0.05;

PlotFrame frame() {
    PlotFrame frame;
    frame.x = {0, 100, false, {}};
    frame.y = {0, 80, false, {}};
    return frame;
}

// Pushes the same everywhere.
class Steady final : public Scene {
public:
    Felt feel(const Touch&, double) noexcept override { return {force, 0, 0}; }
    void begin_again() noexcept override {}
    Point3 force;
};

// A plot's curves, a guidance over them and a finger without weight that goes where it is pushed.
struct Led {
    explicit Led(std::vector<PlotCurve> curves, GuidanceSettings settings = {})
        : plot{},
          felt(lines_of(std::move(curves))),
          near(felt.lines),
          most(settings.most_force),
          guidance(scene, GuidedLines(plot, frame(), felt, kResolution), frame(), settings) {}
    FeltLines lines_of(std::vector<PlotCurve> curves) {
        plot.curves = std::move(curves);
        return felt_lines(plot, frame(), kResolution);
    }
    std::optional<LeadGoal> lead(LeadTo where) { return guidance.lead(where, finger, near.at(finger)); }
    // Until release, with a finger that yields by that many mm/s per newton and is held by friction. Returns how it ended.
    std::optional<LeadEnd> go(double gives = 200, double friction = 0.1, int ticks = 60'000) {
        Point3 velocity;
        for (int i = 0; i < ticks; ++i) {
            const Point3 force = guidance.feel({finger, velocity}, kTick).force;
            EXPECT_LE(length_of(force), most + 1e-9);
            const double pull = length_of(force);
            velocity = pull > friction ? gives * (1 - friction / pull) * force : Point3{};
            finger = finger + kTick * velocity;
            finger.z = std::max(finger.z, 0.0);
            furthest = std::max(furthest, finger.x);
            if (const Nearness at = near.at(finger); at.within) off = std::max(off, distance({finger.x, finger.y}, at.place));
            if (const auto ended = guidance.ended()) return ended->end;
        }
        return std::nullopt;
    }

    Plot plot;
    FeltLines felt;
    NearLines near;
    double most;
    Steady scene;
    Guidance guidance;
    Point3 finger{50, 40, 0};
    double furthest = 0, off = 0;
};

std::vector<PlotCurve> two_curves() {
    return {{"car", {{0, 10}, {20, 30}, {40, 5}, {60, 60}, {100, 0}}}, {"bus", {{0, 70}, {100, 70}}}};
}

double away(const Led& led, double x, double y) {
    return distance({led.finger.x, led.finger.y}, {frame().across(x), frame().down(y)});
}

TEST(Guidance, NotAskedItIsTheScene) {
    Led led(two_curves());
    led.scene.force = {0.3, -0.2, 1};
    std::mt19937 random(1);
    std::uniform_real_distribution<double> at(-20, 120);
    for (int i = 0; i < 1000; ++i)
        EXPECT_EQ(led.guidance.feel({{at(random), at(random), at(random)}, {at(random), 0, 0}}, kTick).force, led.scene.force);
    EXPECT_FALSE(led.guidance.is_leading());
    led.lead(LeadTo::start);
    led.guidance.let_go();
    EXPECT_EQ(led.guidance.feel({led.finger, {}}, kTick).force, led.scene.force);
}

TEST(Guidance, LeadsToEachBeginningInTurn) {
    Led led(two_curves());
    ASSERT_TRUE(led.lead(LeadTo::start));
    EXPECT_EQ(led.go(), LeadEnd::arrived);
    EXPECT_LT(away(led, 0, 10), 0.5);
    ASSERT_TRUE(led.lead(LeadTo::start));
    EXPECT_EQ(led.go(), LeadEnd::arrived);
    EXPECT_LT(away(led, 0, 70), 0.5);
    // Asked once more on the way: the next one at once.
    led.finger = {50, 40, 12};
    EXPECT_EQ(led.lead(LeadTo::start)->curve, 0u);
    led.guidance.feel({led.finger, {}}, kTick);
    EXPECT_EQ(led.lead(LeadTo::start)->curve, 1u);
    EXPECT_EQ(led.go(), LeadEnd::arrived);
    EXPECT_LT(away(led, 0, 70), 0.5);
    EXPECT_LT(led.finger.z, 0.5);
}

TEST(Guidance, FollowsToTheEndAndBack) {
    Led led(two_curves());
    led.finger = {30, 62, 0};
    ASSERT_TRUE(led.lead(LeadTo::follow));
    EXPECT_EQ(led.go(), LeadEnd::arrived);
    EXPECT_LT(away(led, 100, 0), 0.5);
    EXPECT_LT(led.off, 2.5);
    // From the end there is one way only.
    ASSERT_TRUE(led.lead(LeadTo::follow));
    EXPECT_EQ(led.go(), LeadEnd::arrived);
    EXPECT_LT(away(led, 0, 10), 0.5);
    // Asked once more on the way it turns round, and does not come to the end.
    led.furthest = 0;
    ASSERT_TRUE(led.lead(LeadTo::follow));
    EXPECT_EQ(led.go(200, 0.1, 1000), std::nullopt);
    ASSERT_TRUE(led.lead(LeadTo::follow));
    EXPECT_EQ(led.go(), LeadEnd::arrived);
    EXPECT_LT(away(led, 0, 10), 0.5);
    EXPECT_LT(led.furthest, 60);
}

TEST(Guidance, LeadsFromTurnToTurn) {
    Led led(two_curves());
    led.finger = {0, 70, 0};
    const double turns[][2] = {{20, 30}, {40, 5}, {60, 60}};
    bool highest = true;
    for (const auto& [x, y] : turns) {
        const auto goal = led.lead(LeadTo::extremum);
        ASSERT_TRUE(goal);
        EXPECT_EQ(goal->highest, highest);
        EXPECT_EQ(goal->value.x, x);
        EXPECT_EQ(goal->value.y, y);
        EXPECT_EQ(led.go(), LeadEnd::arrived);
        EXPECT_LT(away(led, x, y), 0.5);
        highest = !highest;
    }
    EXPECT_FALSE(led.lead(LeadTo::extremum));
    EXPECT_FALSE(led.guidance.is_leading());
    EXPECT_EQ(led.lead(LeadTo::extremum)->value.x, 40);  // back
    EXPECT_EQ(led.lead(LeadTo::extremum)->value.x, 20);  // once more: the one behind it
}

TEST(Guidance, LeadsOverToTheCurvesThatHaveAValueThere) {
    auto curves = two_curves();
    curves.push_back({"tram", {{50, 20}, {90, 20}}});
    curves.push_back({"dot", {{50, 20}}});
    Led led(curves);
    led.finger = {70, 36, 0};
    auto goal = led.lead(LeadTo::compare);
    ASSERT_TRUE(goal);
    EXPECT_EQ(goal->from, 0u);
    EXPECT_EQ(goal->curve, 1u);
    EXPECT_NEAR(goal->value.y, 70, 1e-9);
    EXPECT_EQ(led.go(), LeadEnd::arrived);
    EXPECT_EQ(led.lead(LeadTo::compare)->curve, 2u);
    EXPECT_EQ(led.go(), LeadEnd::arrived);
    goal = led.lead(LeadTo::compare);
    EXPECT_EQ(goal->curve, 0u);
    EXPECT_NEAR(led.finger.x, goal->place.x, 1);
    led.guidance.let_go();
    led.finger = {10, 10, 0};
    EXPECT_EQ(led.lead(LeadTo::compare)->curve, 0u);  // the tram has not come yet
    EXPECT_FALSE(Led({{"", {{0, 0}, {100, 80}}}}).lead(LeadTo::compare));
    EXPECT_FALSE(Led({}).lead(LeadTo::start));
}

// Uprights, spikes, knots, ways over gaps, ways to and fro: each is gone to its end by a finger that is pushed.
TEST(Guidance, GoesAlongWhateverACurveDoes) {
    PlotCurve gaps{"", {{0, 10}, {20, 30}, {40, 30}, {60, 10}, {70, 70}, {100, 70}}};
    gaps.gaps = {2, 4};
    PlotCurve noise;
    std::mt19937 random(6);
    std::uniform_real_distribution<double> height(35, 45);
    for (int i = 0; i <= 5000; ++i) noise.points.push_back({i / 50.0, height(random)});
    const PlotCurve curves[] = {
        noise,
        {"", {{0, 0}, {30, 0}, {30, 80}, {60, 80}, {60, 5}, {100, 5}}},
        {"", {{0, 0}, {50, 0}, {50.2, 80}, {50.4, 0}, {100, 0}}},
        {"", {{0, 0}, {100, 80}, {100, 0}, {0, 80}}},
        {"", {{0, 40}, {100, 40}, {0, 40.2}, {100, 40.4}}},
        {"", {{0, 10}, {20, 30}, {50, 20}, {100, 80}}, Joining::steps},
        {"", {{0, 10}, {20, 30}, {50, 20}, {100, 80}}, Joining::bars},
        gaps,
    };
    for (const PlotCurve& curve : curves) {
        Led led({curve});
        led.finger = {frame().across(curve.points[0].x), frame().down(curve.points[0].y), 0};
        ASSERT_TRUE(led.lead(LeadTo::follow));
        EXPECT_EQ(led.go(), LeadEnd::arrived);
        const auto& end = led.felt.lines.back().back();
        EXPECT_LT(distance({led.finger.x, led.finger.y}, end), 0.5);
    }
}

// By itself, quicker than what leads it.
TEST(Guidance, AFingerMayComeDownToThePlane) {
    Led led(two_curves());
    led.finger = {30, 62, 40};
    ASSERT_TRUE(led.lead(LeadTo::start));
    for (int i = 0; i < 400; ++i) {
        led.finger.z = 40 - 0.1 * i;
        const Point3 force = led.guidance.feel({led.finger, {0, 0, -100}}, kTick).force;
        ASSERT_TRUE(led.guidance.is_leading());
        ASSERT_LE(force.z, 0.11);  // of its damping
    }
    EXPECT_EQ(led.go(), LeadEnd::arrived);
}

// It is a place, although nothing is felt there.
TEST(Guidance, ACurveOfOnePointIsBothOfItsEnds) {
    Led led({{"", {{5, 5}}}});
    for (const LeadTo where : {LeadTo::start, LeadTo::follow}) {
        ASSERT_TRUE(led.lead(where));
        EXPECT_EQ(led.go(), LeadEnd::arrived);
        EXPECT_LT(away(led, 5, 5), 0.5);
    }
    EXPECT_FALSE(led.lead(LeadTo::extremum));
    EXPECT_FALSE(led.lead(LeadTo::compare));
}

TEST(Guidance, LetsGoOfAFingerThatDoesNotCome) {
    Led led(two_curves());
    led.finger = {30, 62, 0};
    ASSERT_TRUE(led.lead(LeadTo::follow));
    EXPECT_EQ(led.go(0), LeadEnd::resisted);
    EXPECT_EQ(led.guidance.feel({led.finger, {}}, kTick).force, Point3{});
    // One that goes away.
    led.lead(LeadTo::follow);
    double before = 0;
    while (led.guidance.is_leading()) {
        led.finger.y -= 0.05;
        led.guidance.feel({led.finger, {0, -50, 0}}, kTick);
        ++before;
        ASSERT_LT(before, 1000);
    }
    EXPECT_EQ(led.guidance.ended()->end, LeadEnd::left);
    EXPECT_EQ(led.guidance.ended(), std::nullopt);
    // One that is nowhere.
    led.finger = {30, 62, 0};
    led.lead(LeadTo::follow);
    EXPECT_EQ(led.guidance.feel({{NAN, 1, 1}, {}}, kTick).force, Point3{});
    EXPECT_EQ(led.guidance.ended()->end, LeadEnd::left);
    EXPECT_FALSE(led.guidance.lead(LeadTo::start, {INFINITY, 0, 0}, {}));
}

// Wherever the finger is thrown while it is led, and however fast it is told to be.
TEST(Guidance, ItsForceIsBoundedAndBeginsSoftly) {
    for (const GuidanceSettings settings : {GuidanceSettings{}, guidance_for(3.3, 0.51, 1), guidance_for(8, 1.7, 5)}) {
        EXPECT_LE(settings.most_force, 1);
        EXPECT_GE(settings.most_force / settings.stiffness, 1.59);
        Led led(two_curves(), settings);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> at(-3, 3), speed(-500, 500);
        for (const LeadTo where : {LeadTo::start, LeadTo::follow, LeadTo::extremum, LeadTo::compare}) {
            led.finger = {30, 62, 0};
            if (!led.lead(where)) continue;
            EXPECT_LT(length_of(led.guidance.feel({led.finger, {}}, kTick).force), 0.01);
            for (int i = 0; i < 3000; ++i) {
                const Point3 force = led.guidance
                                         .feel({led.finger + Point3{at(random), at(random), at(random)},
                                                {speed(random), speed(random), i % 97 == 0 ? 1e300 : 0}},
                                               i % 5 == 0 ? 0.1 : kTick)
                                         .force;
                ASSERT_TRUE(is_finite(force));
                ASSERT_LE(length_of(force), settings.most_force + 1e-9);
                if (!led.guidance.is_leading()) led.lead(where);
            }
        }
    }
}

// A finger that stands still feels the pull grow no faster than what leads it runs.
TEST(Guidance, NothingJumpsWhileItLeads) {
    Led led(two_curves());
    led.finger = {30, 62, 0};
    led.lead(LeadTo::follow);
    Point3 before;
    for (int i = 0; i < 900; ++i) {
        const Point3 force = led.guidance.feel({led.finger, {}}, kTick).force;
        ASSERT_LE(length_of(force - before), 0.5 * 40 * kTick + 0.8 * kTick / 0.3 + 0.8 * kTick + 1e-9);
        before = force;
    }
    EXPECT_GT(length_of(before), 0.5);
}

TEST(Guidance, WhileItCarriesThePlotFadesAlongThePlaneAndComesBack) {
    Led led(two_curves());
    led.scene.force = {0.3, 0, 1.2};
    led.finger = {50, 40, 0};
    led.lead(LeadTo::start);
    for (int i = 0; i < 400; ++i) led.guidance.feel({led.finger, {}}, kTick);
    led.scene.force = {};
    const Point3 own = led.guidance.feel({led.finger, {}}, kTick).force;
    led.scene.force = {0.3, 0, 1.2};
    const Point3 both = led.guidance.feel({led.finger, {}}, kTick).force;
    EXPECT_NEAR(both.x, own.x, 0.01);
    EXPECT_EQ(both.z, 1.2);
    led.guidance.let_go();
    double share = 0;
    for (int i = 0; i < 310; ++i) {
        const double now = led.guidance.feel({led.finger, {}}, kTick).force.x / 0.3;
        ASSERT_GE(now, share - 1e-9);
        ASSERT_LE(now, share + 0.01);
        share = now;
    }
    EXPECT_NEAR(share, 1, 1e-9);
}

TEST(Guidance, ATickAllocatesNothing) {
    if (!tests::counts_allocations()) GTEST_SKIP() << "this build has an allocator of its own";
    Led led(two_curves());
    std::mt19937 random(7);
    std::uniform_real_distribution<double> at(0, 80);
    const auto before = tests::allocations();
    for (int i = 0; i < 5000; ++i) {
        if (i % 2 == 0) led.lead(static_cast<LeadTo>(i / 2 % 4));
        led.finger = {at(random), at(random), 0};
        led.guidance.feel({led.finger, {}}, kTick);
    }
    EXPECT_EQ(tests::allocations(), before);
    EXPECT_LE(led.guidance.records().size(), 1024u);
}

}  // namespace
}  // namespace tactics::guidance_test
