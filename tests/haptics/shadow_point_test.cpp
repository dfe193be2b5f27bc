// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/shadow_point.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "tests/haptics/meshes.h"

namespace tactics::shadow_point_test {
namespace {

using namespace tests;

static_assert(noexcept(std::declval<ShadowPoint&>().follow({})));

std::string words(const Point3& p) { return std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z); }

// Strokes and leaps around and through a mesh.
struct Hand {
    RandomNumbers random;
    double wide;
    Point3 at{}, goal{};
    Point3 next(int tick) {
        const auto anywhere = [&] {
            return Point3{wide * (random.uniform() - 0.5), wide * (random.uniform() - 0.5), wide * (random.uniform() - 0.5)};
        };
        const bool leaps = tick / 500 % 8 == 7;
        if (leaps || length_of(goal - at) < 0.2) goal = anywhere();
        const double step = leaps ? length_of(goal - at) : 0.1;
        return at = at + std::min(step / std::max(length_of(goal - at), 1e-9), 1.0) * (goal - at);
    }
};

// Whether no way leads nearer: every direction that leads away from the facets that are touched leads away from the finger, too.
// What is touched is found by the twin.
double pull_along_free_ways(const Mesh& mesh, const Point3& shadow, const Point3& finger, double radius, RandomNumbers& random) {
    const Exact3 p(shadow), pull = Exact3(finger) - p;
    const Exact strength = std::sqrt(dot(pull, pull));
    if (strength < 1e-6L) return 0;
    std::vector<Exact3> normals;
    for (const auto& triangle : mesh.triangles) {
        const Exact3 off = p - nearest_by_sides(p, exact_corners(mesh, triangle));
        const Exact far = std::sqrt(dot(off, off));
        if (far < radius + 1e-7L) normals.push_back((1 / far) * off);
    }
    Exact most = 0;
    const auto attempt = [&](Exact3 way) {
        const Exact length = std::sqrt(dot(way, way));
        if (length < 1e-6L) return;
        way = (1 / length) * way;
        for (const Exact3& normal : normals)
            if (dot(normal, way) < 1e-3L) return;
        most = std::max(most, dot(pull, way) / strength);
    };
    for (int i = 0; i < 400; ++i) attempt({random.uniform() - 0.5L, random.uniform() - 0.5L, random.uniform() - 0.5L});
    attempt(pull);
    for (const Exact3& a : normals) attempt(pull - (dot(a, pull) - 2e-3L * strength) * a);
    return static_cast<double>(most);
}

TEST(ShadowPoint, NeverGetsIntoAClosedMesh) {
    struct Case {
        Mesh mesh;
        double radius;
    };
    const std::vector<Case> cases = {{box_mesh({-4, -5, -3}, {4, 5, 3}), 0},
                                     {star_mesh(1, 3), 0},
                                     {star_mesh(2, 5), 0},
                                     {star_mesh(1, 7), 0.7},
                                     {box_mesh({-6, -5, -0.01}, {6, 5, 0.01}), 0}};
    int ticks = 0, unsettled = 0;
    for (const Case& one : cases) {
        const MeshTree tree(facets_of(one.mesh));
        ASSERT_TRUE(tree.facets().closed);
        ShadowPoint shadow(tree, one.radius);
        Hand hand{RandomNumbers(seed_of(1, one.mesh.triangles.size())), 26};
        double before = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 200'000; ++i, ++ticks) {
            const Point3 finger = hand.next(i), was = shadow.follow(finger);
            unsettled += shadow.settled() ? 0 : 1;
            ASSERT_LE(shadow.work(), ShadowPoint::kMostWork + 200);  // the last look began before all was used up
            if (i % 10 != 0) continue;
            ASSERT_LT(std::abs(winding_of(one.mesh, was)), 0.01) << i << " finger " << words(finger) << " is at " << words(was);
            before = distance_to(one.mesh, was);
            ASSERT_GE(before, shadow.radius() - 1e-9) << i << " " << words(was);
        }
    }
    EXPECT_EQ(ticks, 1'000'000);
    EXPECT_LT(unsettled, ticks / 100);
}

TEST(ShadowPoint, IsWhereNoWayNearLeadsNearer) {
    for (const double radius : {0.0, 0.3, 2.0})
        for (int kind = 0; kind < 3; ++kind) {
            const Mesh mesh = kind == 0 ? soup_mesh(60, 11) : kind == 1 ? star_mesh(2, 9) : box_mesh({-4, -5, -3}, {4, 5, 3});
            const MeshTree tree(facets_of(mesh));
            ShadowPoint shadow(tree, radius);
            Hand hand{RandomNumbers(21), 26};
            RandomNumbers random(4);
            int checked = 0;
            for (int i = 0; i < 20'000; ++i) {
                const Point3 finger = hand.next(i), at = shadow.follow(finger);
                if (!shadow.settled() || i % 20 != 0) continue;
                ASSERT_GE(distance_to(mesh, at), shadow.radius() - 1e-9);
                ASSERT_LE(pull_along_free_ways(mesh, at, finger, shadow.radius(), random), 1e-5)
                    << radius << " " << kind << " " << i << " finger " << words(finger) << " at " << words(at);
                ++checked;
            }
            EXPECT_GT(checked, 900);
        }
}

TEST(ShadowPoint, InsideAConvexHollowIsTheNearestPlaceOfAll) {
    const Mesh mesh = ball_mesh(2, [](const Point3&) { return 8.0; });
    const MeshFacets facets = facets_of(mesh);
    MeshFacets open = facets;
    open.closed = false;  // set down within it
    const MeshTree tree(open);
    ShadowPoint shadow(tree, 0);
    shadow.follow({0, 0, 0});
    RandomNumbers random(6);
    for (int i = 0; i < 2000; ++i) {
        const Point3 finger{24 * (random.uniform() - 0.5), 24 * (random.uniform() - 0.5), 24 * (random.uniform() - 0.5)};
        const Point3 at = shadow.follow(finger);
        ASSERT_TRUE(shadow.settled());
        const double away = std::abs(winding_of(mesh, finger)) > 0.5 ? 0 : distance_to(mesh, finger);
        ASSERT_NEAR(length_of(finger - at), away, 3e-5) << words(finger);
    }
}

TEST(ShadowPoint, InACornerOfThreeFacetsIsThereInTheFirstTick) {
    for (const double radius : {0.0, 2.0}) {
        const Mesh mesh = mesh_with({{0, 0, 0}, {90, 0, 0}, {0, 90, 0}, {0, 0, 90}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}});
        const MeshTree tree(facets_of(mesh));
        ShadowPoint shadow(tree, radius);
        shadow.follow({5, 6, 7});
        const Point3 at = shadow.follow({-1, -2, -0.5});
        EXPECT_TRUE(shadow.settled());
        for (const double value : {at.x, at.y, at.z}) EXPECT_NEAR(value, shadow.radius(), 1e-9);
        EXPECT_EQ(shadow.touching().size(), 3u);
        EXPECT_EQ(shadow.follow({-1, -2, -0.5}), at);
    }
}

TEST(ShadowPoint, RollsAroundAnEdgeAndACornerAsABall) {
    const MeshTree tree(facets_of(box_mesh({-10, -10, -10}, {0, 0, 0})));
    ShadowPoint shadow(tree, 2);
    shadow.follow({1, -5, 3});
    const Point3 at_edge = shadow.follow({0.3, -5, 0.6});
    EXPECT_TRUE(shadow.settled());
    const double far = std::hypot(0.3, 0.6);
    EXPECT_NEAR(at_edge.x, 2 * 0.3 / far, 1e-8);
    EXPECT_NEAR(at_edge.z, 2 * 0.6 / far, 1e-8);
    EXPECT_NEAR(at_edge.y, -5, 1e-12);
    const Point3 at_corner = shadow.follow({0.5, 0.5, 0.5});
    EXPECT_TRUE(shadow.settled());
    for (const double value : {at_corner.x, at_corner.y, at_corner.z}) EXPECT_NEAR(value, 2 / std::sqrt(3), 1e-8);
}

TEST(ShadowPoint, OfAPointPassesNoSeamAndAGapOnlyWhereThereIsOne) {
    // Two halves of a floor, apart by so much.
    for (const double apart : {0.0, 1e-7, 1.0}) {
        const MeshTree tree(facets_of(
            mesh_with({{-9, -9, 0}, {0, -9, 0}, {0, 9, 0}, {apart, -9, 0}, {9, -9, 0}, {apart, 9, 0}}, {{0, 1, 2}, {3, 4, 5}})));
        ShadowPoint shadow(tree, 0);
        shadow.follow({apart / 2, -4, 2});
        EXPECT_EQ(shadow.follow({apart / 2, -4, -2}).z < -1, apart == 1.0) << apart;
    }
}

TEST(ShadowPoint, BearsFingersThatAreNowhereOrFarAway) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kEndless = std::numeric_limits<double>::infinity();
    const Mesh one = mesh_with({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    for (const Mesh& mesh : {one, soup_mesh(300, 2), Mesh{}}) {
        const MeshTree tree(facets_of(mesh));
        ShadowPoint shadow(tree, 0);
        const Point3 first = shadow.follow({0.2, 0.2, 1});
        for (const Point3& finger : {Point3{kNan, 1, 1}, Point3{1, -kEndless, 1}}) EXPECT_EQ(shadow.follow(finger), first);
        for (const double away : {-1e300, -1e12, 1e4, 1e300}) {
            EXPECT_TRUE(is_finite(shadow.follow({away, 0.2, -1})));
            EXPECT_TRUE(is_finite(shadow.follow({0.2, 0.2, away})));
        }
    }
}

TEST(ShadowPoint, SetDownInAClosedMeshComesFromAbove) {
    const MeshTree tree(facets_of(box_mesh({-4, -5, -3}, {4, 5, 3})));
    ShadowPoint shadow(tree, 0);
    EXPECT_NEAR(shadow.follow({1, 1, 1}).z, 3, 2e-5);
    EXPECT_TRUE(shadow.arrived());
    shadow.follow({1, 1, 20});
    shadow.lift();
    EXPECT_EQ(shadow.follow({9, 1, 1}), (Point3{9, 1, 1}));
}

TEST(MeshFacets, LeavesOutWhatHasNoAreaOrIsThereTwiceAndCountsIt) {
    Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
    for (const Point3& vertex : std::vector<Point3>(mesh.vertices)) mesh.vertices.push_back(vertex);  // each is there twice
    mesh.triangles.push_back({8, 9, 10});
    mesh.triangles.push_back({8 + 2, 8 + 0, 8 + 1});
    mesh.triangles.push_back({0, 0, 1});
    mesh.triangles.push_back({0, 8, 1});
    const MeshFacets facets = facets_of(mesh);
    EXPECT_EQ(facets.facets.size(), 12u);
    EXPECT_EQ(facets.corners.size(), 8u);
    EXPECT_EQ(facets.twice, 2u);
    EXPECT_EQ(facets.without_area, 2u);
    EXPECT_TRUE(facets.closed);
    EXPECT_EQ(notes_on(facets).size(), 2u);
    mesh.triangles.push_back({0, 1, 7});
    EXPECT_FALSE(facets_of(mesh).closed);
    EXPECT_EQ(facets_of(mesh).open_edges, 2u);
    mesh.vertices[3].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(facets_of(mesh), std::logic_error);
}

// Two roofs whose tops are almost in line: pressing exactly along the tops, whatever rounding makes of it.
TEST(ShadowPoint, AFingerAlongEdgesAlmostInLineStaysOutside) {
    RandomNumbers random(7);
    for (int trial = 0; trial < 2000; ++trial) {
        const double bend = std::pow(10, -7 + 5 * random.uniform()), slope = random.uniform();
        Mesh mesh;
        for (const double y : {23.1, 27.0, 30.9})
            for (const double x : {23.1417, 28.92915, 34.71255})
                mesh.vertices.push_back({x, y, 15 + (slope + (x > 29 ? bend : 0)) * (x - 28.92915) - std::abs(y - 27) * 0.3});
        for (const std::uint32_t a : {0, 1, 3, 4}) {
            mesh.triangles.push_back({a, a + 1, a + 4});
            mesh.triangles.push_back({a, a + 4, a + 3});
        }
        const MeshTree tree(facets_of(mesh));
        ShadowPoint shadow(tree, 0);
        shadow.follow({28.5, 27, 40});
        const double deep = 0.5 + random.uniform(), step = 0.01 + 0.05 * random.uniform();
        for (double x = 28; x < 30.5; x += step) {
            const Point3 finger{x, 27, 15 + slope * (x - 28.92915) - deep};
            const Point3 place = shadow.follow(finger);
            ASSERT_GT(length_of(place - finger), deep / 2)
                << trial << ", " << bend << ": " << words(finger) << ", " << words(place);
        }
    }
}

}  // namespace
}  // namespace tactics::shadow_point_test
