// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/mesh_scene.h"

#include <gtest/gtest.h>

#include "tactics/error.h"
#include "tactics/haptics/scenes/relief_space_scene.h"
#include "tactics/haptics/scenes/surface_mesh.h"
#include "tests/haptics/allocations.h"
#include "tests/haptics/meshes.h"
#include "tests/haptics/reliefs.h"

namespace tactics::mesh_scene_test {
namespace {

using namespace tests;

std::unique_ptr<Scene> scene(const Mesh& mesh, const MeshFeel& feel = {}) {
    std::vector<Phrase> notes;
    return scene_of(mesh, feel, "model", notes);
}
Point3 force_at(Scene& felt, const Point3& finger, const Point3& velocity = {}) {
    return felt.feel({finger, velocity, 0, 0}, 0.001).force;
}

TEST(MeshScene, OnAFlatWallPushesInTheFirstTickAndStraightUp) {
    const Mesh wall = mesh_of(map_of(64, 48, 1.3, [](double, double) { return 3.0; }));
    for (const double radius : {0.0, 2.0}) {
        const auto felt = scene(wall, {{1, 0}, radius});
        EXPECT_EQ(force_at(*felt, {5, 5, 3 + radius + 0.01}), (Point3{}));
        EXPECT_NEAR(force_at(*felt, {5, 5, 3 + radius - 0.5}).z, 0.5, 1.1e-5);
        for (int i = 0; i < 20'000; ++i) {
            const Point3 force = force_at(*felt, {5 + 0.1 * i / 40.7, 5 + 0.077 * i / 40.3, 3 + radius - 2 - std::sin(0.01 * i)});
            ASSERT_LE(std::hypot(force.x, force.y), 1e-12) << i;
            ASSERT_NEAR(force.z, 2 + std::sin(0.01 * i), 1.1e-5);
        }
    }
}

TEST(MeshScene, DampsAlongTheWayOutOnlyAndNeverPullsIn) {
    const Mesh wall = mesh_of(map_of(20, 20, 1, [](double, double) { return 0; }));
    const auto felt = scene(wall, {{1, 5}});
    force_at(*felt, {9, 9, 1});
    EXPECT_NEAR(force_at(*felt, {9, 9, -1}, {300, 0, 0}).z, 1, 2e-5);
    EXPECT_NEAR(force_at(*felt, {9, 9, -1}, {0, 0, -100}).z, 1.5, 2e-5);
    EXPECT_EQ(force_at(*felt, {9, 9, -1}, {0, 0, 1000}).z, 0);
}

// J: what the force does on a finger that goes around, by the trapezoid rule.
double work_around(Scene& felt, const std::vector<Point3>& corners, double step) {
    double work = 0;
    Point3 at = corners.back(), force = force_at(felt, at);
    for (const Point3& corner : corners) {
        const Point3 from = at;
        const int steps = static_cast<int>(std::ceil(length_of(corner - from) / step));
        for (int i = 1; i <= steps; ++i) {
            const Point3 next = from + (1.0 * i / steps) * (corner - from), there = force_at(felt, next);
            work += dot(0.5 * (force + there), next - at);
            at = next;
            force = there;
        }
    }
    return work / 1000;
}

TEST(MeshScene, AroundAClosedWayInAHollowNoWorkIsDone) {
    // A pyramid's hollow, from within: edges and a corner of several facets.
    const Mesh mesh = mesh_with({{0, 0, -6}, {20, 20, 6}, {-20, 20, 6}, {-20, -20, 6}, {20, -20, 6}},
                                {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
    for (const double radius : {0.0, 1.0}) {
        const auto felt = scene(mesh, {{1, 0}, radius});
        force_at(*felt, {0, 0, 5});
        for (const double low : {-4.0, -7.0, -9.0})
            EXPECT_LE(std::abs(work_around(*felt, {{4, 1, low}, {-3, 2, low + 1}, {-2, -4, low}, {0, 0, 6}}, 5e-4)), 1e-9) << low;
    }
}

TEST(MeshScene, NoClosedWayGainsWorkFromASolid) {
    const Mesh mesh = star_mesh(2, 4);
    RandomNumbers random(17);
    for (const double radius : {0.0, 0.5}) {
        const auto felt = scene(mesh, {{1, 0}, radius});
        for (int way = 0; way < 12; ++way) {
            std::vector<Point3> corners;
            for (int k = 0; k < 4; ++k)
                corners.push_back({20 * (random.uniform() - 0.5), 20 * (random.uniform() - 0.5), 20 * (random.uniform() - 0.5)});
            corners.push_back({0, 0, 30});
            force_at(*felt, corners.back());
            EXPECT_LE(work_around(*felt, corners, 1e-3), 1e-9) << way;
        }
    }
}

TEST(MeshScene, TakesNoMemoryWhileItIsFelt) {
    if (!counts_allocations()) GTEST_SKIP() << "sanitizers have an allocator of their own";
    for (const bool smooth : {false, true}) {
        const auto felt = scene(star_mesh(3, 8), {{1, 1}, 0.5, smooth});
        RandomNumbers random(2);
        const std::size_t before = allocations();
        for (int i = 0; i < 3000; ++i) {
            if (i % 100 == 0) felt->begin_again();
            force_at(*felt, {24 * (random.uniform() - 0.5), 24 * (random.uniform() - 0.5), 24 * (random.uniform() - 0.5)});
        }
        EXPECT_EQ(allocations(), before);
    }
}

TEST(MeshScene, SmoothFacetsPushAlmostAsTheBallThatTheyStandFor) {
    const Mesh mesh = ball_mesh(3, [](const Point3&) { return 10.0; });
    double worst[2] = {0, 0};
    for (const bool smooth : {false, true}) {
        const auto felt = scene(mesh, {{1, 0}, 0, smooth});
        for (int i = 0; i < 3000; ++i) {
            const double turn = 0.002 * i, tilt = 0.6 * std::sin(0.0031 * i) + 0.3;
            const Point3 out{std::cos(turn) * std::cos(tilt), std::sin(turn) * std::cos(tilt), std::sin(tilt)};
            if (i == 0) force_at(*felt, 12 * out);
            const Point3 force = force_at(*felt, 9 * out);
            worst[smooth ? 1 : 0] = std::max(worst[smooth ? 1 : 0], length_of(cross(force, out)) / length_of(force));
        }
    }
    EXPECT_GT(worst[0], 0.05);
    EXPECT_LT(worst[1], worst[0] / 4);
}

TEST(MeshScene, OfAHeightMapFeelsAsTheMapItself) {
    const HeightMap map = map_of(60, 50, 0.4, [](double x, double y) {
        return 0.05 * ((x - 12) * (x - 12) + (y - 10) * (y - 10)) + 0.5 * std::abs(x - 9);
    });
    const ReliefSurface surface(map);
    ReliefSpaceScene grid(surface, {1, 0});
    const auto facets = scene(mesh_of(map), {{1, 0}});
    const double tall = map.height();
    RandomNumbers random(3);
    force_at(grid, {12, 10, 40});
    force_at(*facets, {12, tall - 10, 40});
    for (int i = 0; i < 2000; ++i) {
        const double x = 6 + 12 * random.uniform(), y = 5 + 10 * random.uniform();
        const double z = surface.height({x, y}) + 1 - 3 * random.uniform();
        const Point3 a = force_at(grid, {x, y, z}), b = force_at(*facets, {x, tall - y, z});
        ASSERT_NEAR(length_of(a), length_of(b), 5e-5) << i;
    }
}

TEST(MeshScene, RefusesWhatCannotBeFelt) {
    std::vector<Phrase> notes;
    EXPECT_THROW(scene_of(mesh_with({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}), {}, "flat.obj", notes), Error);
    scene_of(mesh_with({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), {}, "one.obj", notes);
    EXPECT_EQ(notes.size(), 1u);
}

TEST(SurfaceMesh, OfAPlotLiesInItsBoxAndLeavesHolesOpen) {
    PlotSurface surface{"", {0, 1, 4}, {10, 30}, {5, 6, 7, 8, 9, NAN}};
    const Mesh mesh = mesh_of(surface, {80, 60, 20});
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.vertices[3], (Point3{0, 0, 0}));
    EXPECT_EQ(mesh.vertices[1], (Point3{20, 60, 20}));
    const auto over = cross(mesh.vertices[mesh.triangles[0][1]] - mesh.vertices[mesh.triangles[0][0]],
                            mesh.vertices[mesh.triangles[0][2]] - mesh.vertices[mesh.triangles[0][0]]);
    EXPECT_GT(over.z, 0);
}

TEST(SurfaceMesh, NoMoreFacetsThanADeviceCanTell) {
    const HeightMap map = map_of(321, 241, 0.1, [](double x, double y) { return 3 * std::sin(x / 3) * std::cos(y / 4); });
    const EnoughFacets fine = enough_facets(map, 0.023), coarse = enough_facets(map, 0.055);
    EXPECT_LT(fine.error, 0.023);
    EXPECT_LT(coarse.error, 0.055);
    EXPECT_GT(coarse.every, fine.every);
    EXPECT_GT(fine.every, 1);
    EXPECT_EQ(coarse.facets, mesh_of(map, coarse.every).triangles.size());
    EXPECT_NE(coarse.words.english().find("0.055 mm"), std::string::npos);
    const EnoughFacets all = enough_facets(map, 1e-9);
    EXPECT_EQ(all.every, 1);
    EXPECT_EQ(all.facets, all.of_all);
}

}  // namespace
}  // namespace tactics::mesh_scene_test
