// SPDX-License-Identifier: Apache-2.0
// Laws of a height map under a finger in space.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tactics/haptics/scenes/relief_space_scene.h"
#include "tests/haptics/allocations.h"
#include "tests/haptics/reliefs.h"

namespace tactics::relief_space_test {
namespace {

using namespace tests;

TEST(ReliefSpace, PushesStraightUpFromLevelGroundInTheFirstTick) {
    const ReliefSurface level(map_of(40, 30, 0.5, [](double, double) { return 4.0; }));
    ReliefSpaceScene scene(level, {1, 1});
    EXPECT_EQ(scene.feel({{10, 7, 5}, {}}, 0.001).force, Point3{});
    EXPECT_EQ(scene.feel({{10, 7, 3.5}, {}}, 0.001).force, (Point3{0, 0, 0.5}));
    // However fast it slides.
    for (int i = 0; i < 200; ++i) {
        const Felt felt = scene.feel({{3 + 0.07 * i, 4 + 0.03 * i, 3 + std::sin(0.1 * i)}, {70, 30, 0}}, 0.001);
        ASSERT_EQ(felt.force.x, 0);
        ASSERT_EQ(felt.force.y, 0);
    }
}

// Round and round, in and out of it: what the finger gets is never more than it has given.
TEST(ReliefSpace, GivesNoMoreThanItGot) {
    for (const HardRelief& relief : hard_reliefs()) {
        const ReliefSurface surface(relief.map);
        ReliefSpaceScene scene(surface, {1, 0});
        const double wide = surface.map().width(), high = surface.map().height();
        constexpr int kSteps = 200'000;
        double work = 0, most = 0;
        Point3 last, force;
        for (int i = 0; i <= kSteps; ++i) {
            const double t = 2 * std::numbers::pi * i / kSteps;
            const Point3 at{wide * (0.5 + 0.4 * std::sin(5 * t)), high * (0.5 + 0.4 * std::sin(7 * t + 1)),
                            surface.highest() + 1 - 3 * std::pow(std::sin(11 * t), 2)};
            const Point3 now = scene.feel({at, {}}, 0.001).force;
            if (i > 0) work += 0.5 * dot(force + now, at - last);
            most = std::max(most, work);
            last = at;
            force = now;
        }
        EXPECT_LT(most, 1e-3) << relief.name;  // N mm: what is left is the sum's own error
    }
}

TEST(ReliefSpace, TakesNoMemoryWhileItIsFelt) {
    if (!counts_allocations()) GTEST_SKIP() << "sanitizers have an allocator of their own";
    const ReliefSurface surface(map_of(160, 120, 0.25, terrain));
    ReliefSpaceScene scene(surface, {1, 1});
    const std::size_t before = allocations();
    for (int i = 0; i < 10'000; ++i)
        scene.feel({{20 + 15 * std::sin(0.01 * i), 15 + 12 * std::cos(0.013 * i), 6 + 4 * std::sin(0.05 * i)}, {}}, 0.001);
    EXPECT_EQ(allocations(), before);
}

}  // namespace
}  // namespace tactics::relief_space_test
