// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/triangulate.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tactics/error.h"
#include "tactics/measure/random.h"

namespace tactics::triangulate_test {
namespace {

using Ring = std::vector<Point3>;

Point3 area_vector(const Ring& ring) {
    Point3 twice;
    for (std::size_t i = 2; i < ring.size(); ++i) twice = twice + cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
    return 0.5 * twice;
}

struct Areas {
    Point3 sum;          // with direction
    double all = 0;      // without
    double against = 0;  // of those that look the other way
};
Areas areas_of(const Ring& ring) {
    const auto triangles = triangulate(ring);
    EXPECT_EQ(triangles.size(), ring.size() - 2);
    Areas areas;
    const Point3 whole = area_vector(ring);
    for (const auto& [a, b, c] : triangles) {
        EXPECT_TRUE(a < ring.size() && b < ring.size() && c < ring.size());
        const Point3 one = area_vector({ring[a], ring[b], ring[c]});
        areas.sum = areas.sum + one;
        areas.all += length_of(one);
        if (dot(one, whole) < 0) areas.against += length_of(one);
    }
    return areas;
}

// For a ring that does not cross itself: no triangle faces the other way, and they fill it without overlap.
void expect_filled(const Ring& ring, const std::string& what) {
    const Areas areas = areas_of(ring);
    const double area = length_of(area_vector(ring));
    EXPECT_NEAR(areas.all, area, 1e-9 * area) << what;
    EXPECT_NEAR(areas.against, 0, 1e-9 * area) << what;
}

Ring turned_over(Ring ring) {
    std::reverse(ring.begin(), ring.end());
    return ring;
}
// Into the other planes.
Ring rolled(const Ring& ring) {
    Ring other;
    for (const Point3& at : ring) other.push_back({at.z, at.x, at.y});
    return other;
}

TEST(Triangulate, FillsWhatGoesInAndOut) {
    const Ring arrow{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}},
        steps{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1, 3, 0}, {0, 3, 0}};
    Ring comb;
    for (int i = 0; i < 20; ++i) comb.insert(comb.end(), {{2.0 * i, 0, 0}, {2.0 * i + 1, i % 3 + 1.0, 0}});
    comb.insert(comb.end(), {{38, -1, 0}, {0, -1, 0}});
    Ring star;
    for (int i = 0; i < 10; ++i) {
        const double angle = std::numbers::pi * i / 5, far = i % 2 == 0 ? 1 : 0.3;
        star.push_back({far * std::cos(angle), far * std::sin(angle), 0});
    }
    for (const Ring& flat : {arrow, steps, turned_over(comb), star})
        for (const Ring& ring : {flat, turned_over(flat), rolled(flat), rolled(turned_over(flat)), rolled(rolled(flat)),
                                 rolled(rolled(turned_over(flat)))})
            expect_filled(ring, std::to_string(flat.size()) + " corners");
}

// A frame as modellers write it: along the outside, over to the hole, around it, and back.
TEST(Triangulate, ACutToAHoleIsNoHarm) {
    const Ring frame{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                     {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
    EXPECT_NEAR(length_of(area_vector(frame)), 12, 1e-12);
    expect_filled(frame, "frame");
}

TEST(Triangulate, CornersOnALineAreKept) {
    expect_filled({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}, {0, 1, 0}}, "an L with one more corner");
}

TEST(Triangulate, RandomRingsThatWindOnceAreFilled) {
    RandomNumbers random(3);
    for (int trial = 0; trial < 300; ++trial) {
        Ring ring;
        const std::size_t count = 4 + random.below(40);
        for (std::size_t i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count),
                         far = 0.1 + random.uniform();
            const double x = far * std::cos(angle), y = far * std::sin(angle);
            ring.push_back({x, y, 0.5 * x - 0.2 * y});  // a plane that is not upright
        }
        expect_filled(ring, "trial " + std::to_string(trial));
    }
}

// A ring that crosses itself, is bent, has no area or has NaN: the right number of triangles, whose directed areas sum to that of
// the ring.
TEST(Triangulate, BadRingsComeToAnEnd) {
    RandomNumbers random(4);
    for (int trial = 0; trial < 300; ++trial) {
        Ring ring;
        const std::size_t count = 3 + random.below(60);
        for (std::size_t i = 0; i < count; ++i)
            ring.push_back({random.uniform(), random.uniform(), trial % 2 == 0 ? 0 : random.uniform()});
        if (trial % 5 == 0) ring[count / 2] = ring[0];
        const Point3 whole = area_vector(ring), sum = areas_of(ring).sum;
        EXPECT_NEAR(length_of(whole - sum), 0, 1e-9);
    }
    EXPECT_EQ(triangulate(Ring(7, Point3{1, 1, 1})).size(), 5u);
    EXPECT_EQ(triangulate(Ring(7, Point3{NAN, INFINITY, 0})).size(), 5u);
    EXPECT_TRUE(triangulate(Ring(2)).empty());
}

TEST(Triangulate, AVeryLongRingIsBounded) {
    Ring comb;
    for (int i = 0; i < 50'000; ++i) comb.push_back({i * 1.0, i % 2 * 100.0 + i % 7, 0});
    comb.push_back({50'000, -50'000, 0});
    EXPECT_EQ(triangulate(comb).size(), comb.size() - 2);
}

TEST(Triangulate, AModelBecomesAMeshAndBack) {
    Model model;
    model.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 5}};
    model.corners = {0, 1, 2, 3, 0, 1, 4};
    model.faces = {{0, 4}, {4, 3}};
    model.objects.resize(3);
    model.objects[0].name = "desk";
    model.objects[1].parent = 0;
    model.objects[1].count = 1;
    model.objects[2].name = "lamp";
    model.objects[2].first = 1;
    model.objects[2].count = 1;
    const Mesh mesh = mesh_of(model, "x");
    EXPECT_EQ(mesh.triangles.size(), 3u);
    ASSERT_EQ(mesh.parts.size(), 2u);
    EXPECT_EQ(mesh.parts[0].name, "desk") << "of what is around it";
    EXPECT_EQ(mesh.parts[0].count, 2u);
    EXPECT_EQ(mesh.parts[1].name, "lamp");
    EXPECT_EQ(mesh.parts[1].first, 2u);
    const Model again = model_of(mesh, false);
    EXPECT_EQ(again.objects.size(), 2u);
    EXPECT_EQ(again.faces.size(), 3u);
    EXPECT_EQ(again.objects[1].first, 2u);
    EXPECT_EQ(again.vertices, model.vertices);
    Model huge = model;
    huge.faces.assign(kMostMeshTriangles + 1, {4, 3});
    EXPECT_THROW(mesh_of(huge, "x"), Error);
}

}  // namespace
}  // namespace tactics::triangulate_test
