// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/enough_mesh.h"

#include <gtest/gtest.h>

#include "tactics/haptics/scenes/mesh_scene.h"
#include "tactics/haptics/scenes/surface_mesh.h"
#include "tests/haptics/meshes.h"
#include "tests/haptics/reliefs.h"

namespace tactics::enough_mesh_test {
namespace {

using namespace tests;

Mesh mesh_with(const MeshFacets& facets) { return {facets.corners, facets.facets, {}}; }

// The farthest that places of one are from the other, by the naive twin.
double farthest(const Mesh& from, const Mesh& other) {
    double most = 0;
    for (const auto& triangle : from.triangles) {
        const Point3 &a = from.vertices[triangle[0]], &b = from.vertices[triangle[1]], &c = from.vertices[triangle[2]];
        for (const Point3& place : {a, 1.0 / 3 * (a + b + c)}) most = std::max(most, distance_to(other, place));
    }
    return most;
}

TEST(EnoughMesh, NeitherSurfaceIsFurtherFromTheOtherThanItSays) {
    RandomNumbers random(4);
    const Mesh meshes[] = {ball_mesh(3, [](const Point3&) { return 30; }),
                           ball_mesh(3, [](const Point3& way) { return 20 + 2 * std::sin(9 * way.x) * std::cos(7 * way.y); }),
                           ball_mesh(3, [&](const Point3&) { return 20 + 0.3 * random.uniform(); }),
                           mesh_of(map_of(18, 14, 0.5, terrain))};
    for (const Mesh& mesh : meshes) {
        const MeshFacets all = facets_of(mesh);
        std::size_t before = all.facets.size() + 1;
        for (const double tolerance : {0.1, 2.0}) {
            const EnoughMesh enough = enough_facets(all, tolerance);
            EXPECT_EQ(enough.of_all, all.facets.size());
            EXPECT_LE(enough.error, tolerance);
            EXPECT_LE(enough.facets.facets.size(), before);
            before = enough.facets.facets.size();
            const Mesh kept = mesh_with(enough.facets);
            EXPECT_LE(farthest(mesh, kept), enough.error + 1e-9);
            EXPECT_LE(farthest(kept, mesh), enough.error + 1e-9);
            const MeshFacets again = facets_of(kept);
            EXPECT_EQ(again.facets.size(), kept.triangles.size());
            EXPECT_EQ(again.closed, all.closed);
            EXPECT_EQ(again.open_edges, all.open_edges);
            EXPECT_EQ(again.crowded_edges, 0u);
        }
        EXPECT_LT(before, all.facets.size());
    }
}

// Narrow facets near the surface, but upright on it, would hold a point that slides over it.
TEST(EnoughMesh, NoFacetIsMuchSteeperThanThoseItStandsFor) {
    const Mesh mesh = mesh_of(map_of(360, 270, 0.09, [](double x, double y) { return 0.45 * terrain(x / 0.45, y / 0.45); }));
    const auto least_up = [](const MeshFacets& facets) {
        double least = 1;
        for (const auto& [a, b, c] : facets.facets) {
            const Point3 over = cross(facets.corners[b] - facets.corners[a], facets.corners[c] - facets.corners[a]);
            least = std::min(least, std::abs(over.z) / length_of(over));
        }
        return least;
    };
    const MeshFacets all = facets_of(mesh);
    const MeshFacets enough = enough_facets(all, 0.055).facets;
    EXPECT_LT(2 * enough.facets.size(), all.facets.size());
    EXPECT_GE(least_up(enough), least_up(all) - 0.1 - 1e-6);
}

TEST(EnoughMesh, OfAFlatGroundLittleMoreThanTheBorderStays) {
    const EnoughMesh enough =
        enough_facets(facets_of(mesh_of(map_of(60, 50, 1, [](double x, double) { return 0.1 * x; }))), 0.055);
    EXPECT_LT(enough.error, 1e-5);
    EXPECT_LT(enough.facets.facets.size(), 2u * 2 * (60 + 50));
    EXPECT_NE(enough.words.english().find(" of 5782 facets are enough for a device that tells 0.055 mm"), std::string::npos)
        << enough.words.english();
}

TEST(EnoughMesh, WhatHasNoSurfaceAroundACornerStaysAsItIs) {
    for (const Mesh& mesh : {soup_mesh(60, 3), box_mesh({0, 0, 0}, {5, 6, 7}), Mesh{}}) {
        const MeshFacets all = facets_of(mesh);
        const EnoughMesh enough = enough_facets(all, 0.5);
        EXPECT_EQ(enough.facets.facets, all.facets);
        EXPECT_EQ(enough.facets.corners, all.corners);
        EXPECT_EQ(enough.error, 0);
        EXPECT_EQ(enough.words.english().rfind("all ", 0), 0u);
    }
}

TEST(EnoughMesh, IsWhatADeviceOfThatResolutionFeelsAndIsTold) {
    const Mesh ball = ball_mesh(5, [](const Point3&) { return 30; });
    std::vector<Phrase> fine, coarse;
    const auto all = scene_of(ball, {.law = {1, 0}, .radius = 1}, "ball", fine);
    const auto enough = scene_of(ball, {.law = {1, 0}, .radius = 1, .resolution = 0.055}, "ball", coarse);
    EXPECT_TRUE(fine.empty());
    ASSERT_EQ(coarse.size(), 1u);
    EXPECT_NE(coarse[0].english().find("0.055 mm"), std::string::npos);
    for (int i = 0; i < 2000; ++i) {
        const double turn = 0.01 * i, tilt = std::sin(0.003 * i);
        const Point3 way{std::cos(turn) * std::cos(tilt), std::sin(turn) * std::cos(tilt), std::sin(tilt)};
        const Touch touch{(i == 0 ? 40 : 30.2) * way, {}, 0, 0};
        EXPECT_NEAR(length_of(all->feel(touch, 0.001).force), length_of(enough->feel(touch, 0.001).force), 0.055 + 0.01) << i;
    }
}

}  // namespace
}  // namespace tactics::enough_mesh_test
