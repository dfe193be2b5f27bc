// SPDX-License-Identifier: Apache-2.0
// Laws of what is felt of the curves of a plot, however many strokes they have.
#include "tactics/haptics/scenes/line_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tactics/haptics/scenes/curve_scene.h"
#include "tests/haptics/plot_lines.h"
#include "tests/haptics/work_round.h"

namespace tactics::line_field_test {
namespace {

Line sine(int points) {
    Line line;
    for (int i = 0; i <= points; ++i) line.push_back({120.0 * i / points, 40 + 20 * std::sin(i * 4 * std::numbers::pi / points)});
    return line;
}
Line noise(int points, unsigned seed, double low, double high) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> up(low, high);
    Line line;
    for (int i = 0; i <= points; ++i) line.push_back({120.0 * i / points, up(random)});
    return line;
}
const Line kCorner = {{20, 60}, {60, 20}, {90, 70}};
const Line kSpike = {{0, 60}, {58, 60}, {60, 10}, {62, 60}, {120, 60}};
const Line kStairs = {{0, 60}, {60, 60}, {60, 20}, {120, 20}};

struct Case {
    const char* name;
    std::vector<Line> lines;
};
std::vector<Case> cases() {
    return {{"corner", {kCorner}},
            {"spike", {kSpike}},
            {"step", {kStairs}},
            {"sine", {sine(400)}},
            {"two", {sine(40), kCorner}},
            {"noise", {noise(60, 3, 10, 70)}},
            {"dense", {noise(1500, 4, 10, 70)}},
            {"band", {noise(8000, 4, 38, 42)}}};
}

Point3 somewhere(std::mt19937& random) {
    std::uniform_real_distribution<double> x(-15, 135), y(-10, 90), z(-3, 12);
    return {x(random), y(random), z(random)};
}

TEST(LineField, IsAsFarAsASearchThroughAllSays) {
    for (const Case& one : cases()) {
        const LineField::Reach reach;
        const LineField field(one.lines, reach);
        const double half = field.pitch() / 2;
        std::mt19937 random(1);
        for (int i = 0; i < 5000; ++i) {
            Point3 at = somewhere(random);
            if (i % 2 == 0) at.z = 0;
            const double naive = naive_distance(one.lines, at);
            const LineField::Felt told = field.at(at);
            if (naive > reach.far - half) continue;
            ASSERT_TRUE(told.within) << one.name << " " << at.x << " " << at.y << " " << at.z;
            ASSERT_GE(told.distance, naive - reach.blend / 4 - half) << one.name;
            ASSERT_LE(told.distance, naive + (naive > 0.5 ? half / 10 : half)) << one.name;
        }
        EXPECT_FALSE(field.at({1e9, 0, 0}).within);
        EXPECT_FALSE(field.at({60, 40, -10.1}).within);
        EXPECT_FALSE(field.at({std::nan(""), 40, 0}).within);
    }
    EXPECT_FALSE(LineField({{{1, 1}}, {}}, {}).at({1, 1, 0}).within);
}

// Halves of a straight line, each again in halves: where a vertex is cannot be felt, and all force is across.
TEST(LineField, OfAStraightLineTheSlopeIsAcrossIt) {
    constexpr double kSingle = 1e-4;  // what single precision leaves of ten millimetres
    Line line;
    for (int i = 0; i <= 200; ++i) line.push_back({0.5 * i + 10, 0.3 * i + 10});
    const LineField field({line}, {});
    const double length = std::hypot(0.5, 0.3);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> along(5, 100), across(-9, 9), up(-2, 8);
    for (int i = 0; i < 10'000; ++i) {
        const double s = along(random), t = across(random);
        const Point3 at{10 + (s * 0.5 - t * 0.3) / length, 10 + (s * 0.3 + t * 0.5) / length, up(random)};
        const LineField::Felt told = field.at(at);
        if (!told.within || std::abs(t) < 3 * field.pitch()) continue;
        ASSERT_NEAR(told.distance, std::hypot(t, at.z), kSingle);
        ASSERT_NEAR(told.slope.x * 0.5 + told.slope.y * 0.3, 0, kSingle);
        ASSERT_NEAR(length_of(told.slope), 1, kSingle);
    }
}

// Between two lines the ridge is cut by a parabola that both sides run into.
TEST(LineField, TheEdgeBetweenTwoLinesIsRound) {
    constexpr double kApart = 8;
    for (const double blend : {0.5, 1.5}) {
        const LineField field({{{0, 0}, {50, 0}}, {{0, kApart}, {50, kApart}}}, {10, blend});
        for (double t = -3.5; t <= 3.5; t += 0.01) {
            const double sharp = kApart / 2 - std::abs(t);
            const double round = std::abs(t) < blend / 2 ? kApart / 2 - blend / 4 - t * t / blend : sharp;
            ASSERT_NEAR(field.at({25, kApart / 2 + t, 0}).distance, round, LineField::kPitch / 2) << blend << " " << t;
        }
    }
}

TEST(LineField, TheSlopeIsThatOfTheDistance) {
    constexpr double kStep = 1e-6;
    for (const Case& one : cases()) {
        const LineField field(one.lines, {});
        std::mt19937 random(4);
        int looked = 0;
        for (int i = 0; i < 20'000; ++i) {
            const Point3 at = somewhere(random);
            const LineField::Felt told = field.at(at);
            if (!told.within || told.distance > 9.9 || std::abs(at.z) > 9.9) continue;
            const auto change = [&](const Point3& way) {
                return (field.at(at + kStep * way).distance - field.at(at - kStep * way).distance) / (2 * kStep);
            };
            ++looked;
            ASSERT_LE(length_of(Point3{change({1, 0, 0}), change({0, 1, 0}), change({0, 0, 1})} - told.slope), 1e-3) << one.name;
        }
        EXPECT_GT(looked, 1000) << one.name;
    }
}

TEST(CurveScene, NoWayRoundGainsEnergy) {
    for (const Case& one : cases()) {
        std::mt19937 random(5);
        for (const NamedFixture& fixture : fixtures()) {
            CurveScene scene(one.lines, fixture.settings);
            for (int i = 0; i < 4; ++i) {
                const Line& line = one.lines[0];
                const Point near = line[random() % line.size()];
                const double radius = 1 + static_cast<double>(random() % 5), up = i % 2 == 0 ? 0.3 : 2;
                EXPECT_LE(std::abs(work_round(scene, loop_round({near.x + 1, near.y - 1, up}, radius))), kNanojoule)
                    << fixture.name << " " << one.name << " at " << near.x << " " << near.y << " radius " << radius;
            }
        }
    }
}

// Over a micrometre the force changes by no more than the steepest pull, and the quickest turn of the strongest, allow: 1 in half
// of the blend. Twice as much and a bit is the grid's, at whose nodes the paraboloids stand. A rod's middle, where a finger does
// not stay, is as steep as its strength over half a pitch.
TEST(CurveScene, TheForceNeverJumps) {
    constexpr double kStep = 1e-3;
    for (const NamedFixture& fixture : fixtures()) {
        const bool rod = fixture.settings.form == FixtureForm::rod;
        const double blend = std::min(LineField::Reach{}.blend, fixture.settings.radius / 2);
        const double turn = fixture.settings.strength * 2 / blend, steep = slopes_of(fixture.settings).rise;
        const double most = 2.3 * (rod ? fixture.settings.strength / (LineField::kPitch / 2) : steep + turn);
        for (const Case& one : cases()) {
            CurveScene scene(one.lines, fixture.settings);
            std::mt19937 random(6);
            for (int i = 0; i < 40; ++i) {
                Point3 at = somewhere(random), to = somewhere(random);
                if (i % 2 == 0) at.z = to.z = 0;
                const int steps = static_cast<int>(length_of(to - at) / kStep);
                const Point3 way = 1.0 / steps * (to - at);
                Point3 before = scene.feel({at, {}}, 0.001).force;
                for (int k = 1; k <= steps; ++k) {
                    const Point3 here = at + static_cast<double>(k) * way, now = scene.feel({here, {}}, 0.001).force;
                    ASSERT_LE(length_of(now - before), most * kStep * 1.01)
                        << fixture.name << " " << one.name << " " << here.x << " " << here.y << " " << here.z;
                    ASSERT_LE(length_of(now), 1.05 * fixture.settings.strength) << fixture.name << " " << one.name;
                    before = now;
                }
            }
        }
    }
}

// In two halves of a way there is half of the damping's force on each, wherever it is: it only takes energy.
TEST(CurveScene, DampingOnlyTakesEnergy) {
    for (const Case& one : cases()) {
        CurveScene damped(one.lines, FixtureSettings{}, 3), still(one.lines, FixtureSettings{});
        std::mt19937 random(9);
        std::uniform_real_distribution<double> speed(-200, 200);
        for (int i = 0; i < 5000; ++i) {
            const Touch touch{somewhere(random), {speed(random), speed(random), speed(random)}};
            const Point3 more = damped.feel(touch, 0.001).force - still.feel(touch, 0.001).force;
            ASSERT_LE(dot(more, touch.velocity), 1e-9);
        }
    }
}

}  // namespace
}  // namespace tactics::line_field_test
