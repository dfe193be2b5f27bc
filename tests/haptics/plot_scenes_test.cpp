// SPDX-License-Identifier: Apache-2.0
// Laws of what is felt of a plot: axes, grid and points; curves are in line_field_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "tactics/haptics/scenes/curve_scene.h"
#include "tactics/haptics/scenes/parts_scene.h"
#include "tactics/haptics/scenes/plot_walls.h"
#include "tactics/haptics/scenes/points_scene.h"
#include "tests/haptics/allocations.h"
#include "tests/haptics/plot_lines.h"
#include "tests/haptics/work_round.h"

namespace tactics::plot_scenes_test {
namespace {

Line noise(int points, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> up(10, 70);
    Line line;
    for (int i = 0; i <= points; ++i) line.push_back({120.0 * i / points, up(random)});
    return line;
}
Point3 somewhere(std::mt19937& random) {
    std::uniform_real_distribution<double> x(-15, 135), y(-10, 90), z(-3, 12);
    return {x(random), y(random), z(random)};
}

// The figures of the two reconstructions, as they were computed when they were found: peak and where, core below 5 % of C,
// steepest rise and fall (N/m).
TEST(Fixture, HasTheFiguresOfItsReconstruction) {
    struct Row {
        FixtureSettings settings;
        double peak, at, core, rise, fall;
    };
    const Row rows[] = {{{FixtureForm::r1, 1.5, 10, 4, 1.2, 1.6, 6}, 1.49, 2.74, 0.50, 1511, 601},
                        {{FixtureForm::r1, 1.5, 10, 8, 0.8, 1.6, 6}, 1.50, 1.83, 0.44, 3004, 601},
                        {{FixtureForm::r1, 1.5, 10, 2.5, 1.8, 1.6, 6}, 1.45, 3.55, 0.70, 945, 601},
                        {{FixtureForm::r2, 1.5, 10, 2, 1.2, 4, 6}, 1.44, 2.49, 0.27, 1071, 381}};
    for (const Row& row : rows) {
        double peak = 0, at = 0, core = 0;
        for (double d = 0; d <= 10; d += 0.001) {
            const double force = pull(row.settings, d);
            if (force > peak) peak = force, at = d;
            if (peak < 0.05 * row.settings.strength) core = d;
        }
        const FixtureSlopes slopes = slopes_of(row.settings);
        EXPECT_NEAR(peak, row.peak, 0.005);
        EXPECT_NEAR(at, row.at, 0.01);
        EXPECT_NEAR(core, row.core, 0.01);
        EXPECT_NEAR(slopes.rise * 1000, row.rise, 2);
        EXPECT_NEAR(slopes.fall * 1000, row.fall, 2);
    }
}

TEST(Fixture, IsNothingAtTheLineAndAtItsRadius) {
    for (const NamedFixture& fixture : fixtures()) {
        EXPECT_EQ(pull(fixture.settings, 0), 0) << fixture.name;
        EXPECT_NEAR(pull(fixture.settings, fixture.settings.radius - 1e-9), 0, 1e-7) << fixture.name;
        EXPECT_EQ(pull(fixture.settings, fixture.settings.radius + 1e-9), 0) << fixture.name;
        EXPECT_EQ(pull(fixture.settings, std::nan("")), 0) << fixture.name;
    }
}

TEST(PlotFrame, PlacesAndValuesAreInverse) {
    PlotFrame odd = frame();
    odd.x = {0.01, 1000, true, {}};
    odd.depth = 30;
    odd.z = {-2, 3, false, {}};
    const Point3 back = odd.values(odd.place(3, -2, 1));
    EXPECT_NEAR(back.x, 3, 1e-9);
    EXPECT_NEAR(back.y, -2, 1e-9);
    EXPECT_NEAR(back.z, 1, 1e-9);
    EXPECT_NEAR(odd.place(1000, 5).x, 120, 1e-9);
    EXPECT_NEAR(odd.place(1000, 5).y, 0, 1e-9);
}

TEST(PlotAxes, AreSilentWithinTheFieldAndHaveABumpAtEachTick) {
    PlotAxes axes(frame(), {});
    for (double x = 2; x < 120; x += 0.7)
        for (double y = 1; y < 78; y += 0.7) ASSERT_EQ(axes.feel({{x, y, 0}, {}}, 0.001).force, Point3{});
    // Half a mm below the axis: up by k x between the ticks; at a tick by the bump more, and along it nothing on its top.
    const Felt between = axes.feel({{36, 80.5, 0}, {}}, 0.001), tick = axes.feel({{48, 80.5, 0}, {}}, 0.001);
    EXPECT_NEAR(between.force.y, -0.5, 1e-12);
    EXPECT_NEAR(between.force.x, 0, 1e-12);
    EXPECT_NEAR(tick.force.y, -2.0, 1e-12);
    EXPECT_NEAR(tick.force.x, 0, 1e-9);
    EXPECT_LT(axes.feel({{47, 80.5, 0}, {}}, 0.001).force.x, -0.3);  // up the bump: it holds the finger back
    EXPECT_GT(axes.feel({{49, 80.5, 0}, {}}, 0.001).force.x, 0.3);
    EXPECT_NEAR(axes.feel({{-0.5, 20, 0}, {}}, 0.001).force.x, 0.5, 1e-12);
}

TEST(PlotAxes, NoWayRoundGainsEnergy) {
    PlotAxes axes(frame(), {});
    for (const Point3 middle : {Point3{24, 80, 0}, Point3{0, 40, 1}, Point3{0, 80, 0}, Point3{60, 82, 0}})
        EXPECT_LE(std::abs(work_round(axes, loop_round(middle, 4))), kNanojoule) << middle.x << " " << middle.y;
}

TEST(PlotAxes, DampingOnlyTakesEnergy) {
    PlotAxes axes(frame(), {{1, 3}});
    PlotAxes still(frame(), {{1, 0}});
    std::mt19937 random(9);
    std::uniform_real_distribution<double> x(-3, 123), y(76, 84), v(-200, 200);
    for (int i = 0; i < 20'000; ++i) {
        const Touch touch{{x(random), y(random), 0}, {v(random), v(random), v(random)}};
        const Point3 more = axes.feel(touch, 0.001).force - still.feel(touch, 0.001).force;
        ASSERT_LE(dot(more, touch.velocity), 1e-9);
    }
}

TEST(PlotGrid, ResistsAcrossItsLinesOnly) {
    PlotGrid grid(frame(), {4, 2});
    const Felt on = grid.feel({{48, 30, 0}, {100, 70, 0}}, 0.001);
    EXPECT_NEAR(on.force.x, -0.4, 1e-12);  // 4 N s/m at 0.1 m/s
    EXPECT_EQ(on.force.y, 0);
    EXPECT_EQ(grid.feel({{54, 30, 0}, {100, 70, 0}}, 0.001).force, Point3{});
    double before = 0;
    for (double x = 40; x < 56; x += 1e-3) {
        const double now = grid.feel({{x, 30, 0}, {100, 0, 0}}, 0.001).force.x;
        ASSERT_LE(std::abs(now - before), 0.4 * 1e-3 * 2 + 1e-12);
        ASSERT_LE(now, 0);
        before = now;
    }
}

TEST(PlotWall, IsASpringThatDoesNotPull) {
    PlotWall wall({2, 1});
    EXPECT_EQ(wall.feel({{5, 5, 0.1}, {0, 0, -50}}, 0.001).force, Point3{});
    EXPECT_NEAR(wall.feel({{5, 5, -0.5}, {}}, 0.001).force.z, 1, 1e-12);
    EXPECT_NEAR(wall.feel({{5, 5, -0.5}, {30, 30, -100}}, 0.001).force.z, 1.1, 1e-12);
    EXPECT_EQ(wall.feel({{5, 5, -0.01}, {0, 0, 500}}, 0.001).force.z, 0);  // on the way out it does not hold on
    const Felt slid = wall.feel({{5, 5, -0.5}, {300, -200, 0}}, 0.001);
    EXPECT_EQ(slid.force.x, 0);
    EXPECT_EQ(slid.force.y, 0);
}

std::vector<Point3> cloud(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(0, 60), y(0, 40);
    std::vector<Point3> points;
    for (int i = 0; i < count; ++i) points.push_back({x(random), y(random), 0});
    return points;
}

TEST(PointsScene, APointAloneIsASphere) {
    PointsScene scene({{20, 20, 0}, {40, 20, 0}}, {3, 1}, 0.05);
    EXPECT_NEAR(scene.feel({{21, 20, 0}, {}}, 0.001).force.x, 2, 1e-12);
    EXPECT_NEAR(scene.feel({{20, 20, 2}, {}}, 0.001).force.z, 1, 1e-12);
    EXPECT_EQ(scene.feel({{20, 20, 0}, {}}, 0.001).force, Point3{});  // which way out nobody knows
    EXPECT_EQ(scene.feel({{24, 20, 0}, {}}, 0.001).force, Point3{});
    EXPECT_EQ(PointsScene({}, {}, 0.05).feel({{1, 1, 1}, {}}, 0.001).force, Point3{});
    EXPECT_EQ(scene.feel({{std::nan(""), 20, 0}, {}}, 0.001).force, Point3{});
}

TEST(PointsScene, NoWayRoundGainsEnergyAndNoCloudIsStiff) {
    for (const int count : {10, 300, 20'000}) {
        const PointsFeel feel{3, 1};
        PointsScene scene(cloud(count, 11), feel, 0.05);
        EXPECT_LE(scene.size(), static_cast<std::size_t>(count));
        for (const Point3 middle : {Point3{20, 20, 0}, Point3{30, 5, 1}})
            EXPECT_LE(std::abs(work_round(scene, loop_round(middle, 5))), kNanojoule) << count;
        std::mt19937 random(12);
        constexpr double kStep = 1e-3;
        for (int i = 0; i < 2000; ++i) {
            Point3 at = cloud(1, static_cast<unsigned>(random()))[0];
            at.z = 0.8;
            const Point3 a = scene.feel({at, {}}, 0.001).force, b = scene.feel({at + Point3{0, 0, kStep}, {}}, 0.001).force;
            ASSERT_LE(length_of(b - a), 3 * feel.stiffness * kStep) << count;
        }
    }
}

TEST(PlotScenes, ATickAllocatesNothing) {
    if (!tests::counts_allocations()) GTEST_SKIP() << "this build has an allocator of its own";
    std::vector<std::unique_ptr<Scene>> parts;
    parts.push_back(std::make_unique<PlotWall>(ForceLaw{}));
    parts.push_back(std::make_unique<PlotAxes>(frame(), AxisFeel{}));
    parts.push_back(std::make_unique<PlotGrid>(frame(), GridFeel{}));
    parts.push_back(std::make_unique<CurveScene>(std::vector<Line>{noise(2000, 4)}, FixtureSettings{}));
    parts.push_back(std::make_unique<PointsScene>(cloud(1000, 5), PointsFeel{}, 0.05));
    PartsScene scene(std::move(parts), {{-INFINITY, -10, -INFINITY}, {130, INFINITY, 10}});
    std::mt19937 random(13);
    const std::size_t before = tests::allocations();
    Point3 sum;
    for (int i = 0; i < 10'000; ++i) sum = sum + scene.feel({somewhere(random), {10, 20, 30}}, 0.001).force;
    EXPECT_EQ(tests::allocations(), before);
    EXPECT_TRUE(is_finite(sum));
    EXPECT_EQ(scene.feel({{60, 40, 11}, {}}, 0.001).force, Point3{});  // the box sleeps
}

}  // namespace
}  // namespace tactics::plot_scenes_test
