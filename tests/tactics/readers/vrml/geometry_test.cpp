// SPDX-License-Identifier: Apache-2.0
// The shapes of VRML97 and X3D, by what is known of them: areas, volumes, boxes.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/tactics/readers/vrml/worlds.h"

namespace tactics::geometry_test {
namespace {

using namespace tests;

Model shape(const std::string& geometry, const std::string& head = kVrml97) {
    Model model = read_world(head + "Shape { geometry " + geometry + " }").model;
    expect_sound(model);
    return model;
}
constexpr double kCubicMetre = 1e9, kSquareMetre = 1e6;

TEST(VrmlGeometry, ABoxHasSixFacesThatLookOutwards) {
    const Model box = shape("Box { size 1 2 3 }");
    ASSERT_EQ(box.objects.size(), 1u);
    EXPECT_EQ(box.faces.size(), 6u);
    EXPECT_EQ(box.objects[0].primitive, Primitive::box);
    EXPECT_TRUE(box.objects[0].one_sided);
    EXPECT_NEAR(volume_of(box), 6 * kCubicMetre, 1);
    EXPECT_NEAR(area_of(box), 22 * kSquareMetre, 1);
    for (const ModelFace& face : box.faces) {
        const auto ring = ring_of(box, face);
        Point3 middle;
        for (const Point3& at : ring) middle = middle + 0.25 * at;
        EXPECT_GT(dot(middle, area_vector(ring)), 0);
    }
    // y of the file is up, z is towards who looks.
    expect_near(bounds_of(box, box.objects[0]).size(), {1000, 3000, 2000}, 1e-9);
    const PrimitiveFrame& frame = box.objects[0].frame;
    expect_near(frame.c, {0, 0, 1000}, 1e-9);
    EXPECT_NEAR(8 * dot(cross(frame.a, frame.b), frame.c), 6 * kCubicMetre, 1);
}

TEST(VrmlGeometry, ABoxWithoutThicknessIsASheet) {
    for (const char* const size : {"0 2 3", "2 0 3", "2 3 0"}) {
        const Model sheet = shape(std::string("Box { size ") + size + " }");
        EXPECT_EQ(sheet.faces.size(), 1u);
        EXPECT_NEAR(area_of(sheet), 6 * kSquareMetre, 1);
        EXPECT_EQ(sheet.objects[0].primitive, Primitive::none);
        EXPECT_FALSE(sheet.objects[0].one_sided);
    }
    for (const char* const size : {"0 0 3", "-1 2 3"})
        EXPECT_NE(refusal_of(kVrml97 + "Shape { geometry Box { size " + size + " } }").find("size that is not over 0"),
                  std::string::npos);
}

// The area of a regular polygon and the volumes over it.
TEST(VrmlGeometry, RoundThingsAreClosedAndAsLargeAsTheirSidesSay) {
    constexpr double kSides = 32;
    const double base = kSides / 2 * std::sin(2 * std::numbers::pi / kSides) * 0.25 * kSquareMetre;
    const Model cylinder = shape("Cylinder { radius 0.5 height 3 }"), cone = shape("Cone { bottomRadius 0.5 height 3 }"),
                ball = shape("Sphere { radius 0.5 }");
    EXPECT_NEAR(volume_of(cylinder), base * 3000, 1);
    EXPECT_NEAR(volume_of(cone), base * 1000, 1);
    EXPECT_NEAR(volume_of(ball), 4.0 / 3 * std::numbers::pi * 0.125 * kCubicMetre, 0.02 * kCubicMetre);
    for (const Model& one : {cylinder, cone, ball}) {
        EXPECT_NEAR(openness_of(one), 0, 1e-6);
        EXPECT_TRUE(one.objects[0].one_sided);
    }
    expect_near(bounds_of(cylinder, cylinder.objects[0]).size(), {1000, 1000, 3000}, 1e-9);
    expect_near(bounds_of(ball, ball.objects[0]).size(), {1000, 1000, 1000}, 1e-9);
    EXPECT_EQ(cylinder.objects[0].primitive, Primitive::cylinder);
    EXPECT_EQ(cone.objects[0].primitive, Primitive::cone);
    EXPECT_EQ(ball.objects[0].primitive, Primitive::sphere);
    expect_near(cone.objects[0].frame.middle + cone.objects[0].frame.c, {0, 0, 1500}, 1e-9);
    EXPECT_NEAR(length_of(cylinder.objects[0].frame.a), 500, 1e-9);
}

TEST(VrmlGeometry, PartsOfRoundThingsCanBeOff) {
    const Model tube = shape("Cylinder { top FALSE bottom FALSE }"), tent = shape("Cone { bottom FALSE }"),
                disc = shape("Cylinder { side FALSE top FALSE }");
    EXPECT_EQ(tube.faces.size(), 32u);
    EXPECT_EQ(tent.faces.size(), 32u);
    ASSERT_EQ(disc.faces.size(), 1u);
    EXPECT_LT(area_vector(ring_of(disc, disc.faces[0])).z, 0) << "a bottom looks down";
    EXPECT_FALSE(tube.objects[0].one_sided) << "its inside can be seen and felt";
}

constexpr const char* kPyramid =
    "coord Coordinate { point [ -1 0 -1, 1 0 -1, 1 0 1, -1 0 1, 0 3 0 ] } "
    "coordIndex [ 0 1 2 3 -1, 0 4 1 -1, 1 4 2 -1, 2 4 3 -1, 3 4 0 -1 ]";

TEST(VrmlGeometry, FacesStayAsTheyAreWritten) {
    const Model pyramid = shape(std::string("IndexedFaceSet { ") + kPyramid + " }");
    EXPECT_EQ(pyramid.faces.size(), 5u);
    EXPECT_EQ(pyramid.faces[0].count, 4u);
    EXPECT_NEAR(volume_of(pyramid), 4 * kCubicMetre, 1);
    const Model inside_out = shape(std::string("IndexedFaceSet { ccw FALSE solid FALSE ") + kPyramid + " }");
    EXPECT_NEAR(volume_of(inside_out), -4 * kCubicMetre, 1);
    EXPECT_FALSE(inside_out.objects[0].one_sided);
}

TEST(VrmlGeometry, BrokenFacesAreLeftOutAndCounted) {
    const ReadWorld world =
        read_world(kVrml97 +
                   "Shape { geometry IndexedFaceSet { coord Coordinate { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0, 2 0 0 ] }\n"
                   "coordIndex [ 0 1 2 3 -1, 0 1 -1, 0 1 9 -1, 0 1 4 -1, 0 0 1 1 -1, 0 1 2 2 3 0 -1 -1, 0 1 1e30 ] } }");
    EXPECT_EQ(world.model.faces.size(), 2u) << "a square, and once more with corners twice";
    for (const ModelFace& face : world.model.faces) EXPECT_EQ(face.count, 4u);
    ASSERT_EQ(world.notes.size(), 1u);
    EXPECT_EQ(
        world.notes[0].english(),
        "left out: faces without area, with fewer than 3 corners or with a corner that is not there (5 times, first in line 2)");
}

TEST(VrmlGeometry, AShortListOfFacesMayHaveALongListOfPoints) {
    std::string points;
    for (int i = 0; i < 100; ++i) points += std::to_string(i % 10) + " " + std::to_string(i / 10) + " 0, ";
    const Model few = shape("IndexedFaceSet { coord Coordinate { point [" + points + "] } coordIndex [ 0 9 99 90 -1 ] }");
    EXPECT_EQ(few.vertices.size(), 4u);
    EXPECT_NEAR(area_of(few), 81 * kSquareMetre, 1);
}

TEST(VrmlGeometry, AnElevationGridLooksUp) {
    const Model hill = shape("ElevationGrid { xDimension 3 zDimension 2 xSpacing 2 zSpacing 5 height [ 0 1 0 0 1 0 ] }");
    ASSERT_EQ(hill.faces.size(), 2u);
    for (const ModelFace& face : hill.faces) EXPECT_GT(area_vector(ring_of(hill, face)).z, 0);
    expect_near(bounds_of(hill, hill.objects[0]).size(), {4000, 5000, 1000}, 1e-9);
    EXPECT_NEAR(area_of(hill), 2 * 5 * std::sqrt(5.0) * kSquareMetre, 1);
    EXPECT_NE(refusal_of(kVrml97 + "\nShape { geometry ElevationGrid { xDimension 3 zDimension 3 height [ 1 2 ] } }")
                  .find("test.wrl:3"),
              std::string::npos);
}

TEST(VrmlGeometry, AnExtrusionIsWhatItsSectionSweeps) {
    // The default is a box of 2 x 1 x 2.
    const Model box = shape("Extrusion { }");
    EXPECT_EQ(box.faces.size(), 6u);
    EXPECT_NEAR(volume_of(box), 4 * kCubicMetre, 1);
    EXPECT_NEAR(openness_of(box), 0, 1e-6);
    expect_near(bounds_of(box, box.objects[0]).size(), {2000, 2000, 1000}, 1e-9);
    // Lying down: the spine along x.
    const Model lying = shape("Extrusion { spine [ 0 0 0, 3 0 0 ] }");
    EXPECT_NEAR(volume_of(lying), 12 * kCubicMetre, 1);
    expect_near(bounds_of(lying, lying.objects[0]).size(), {3000, 2000, 2000}, 1e-9);
    // A frustum: h / 3 (A + B + sqrt(A B)).
    const Model frustum = shape("Extrusion { spine [ 0 0 0, 0 3 0 ] scale [ 1 1, 0.5 0.5 ] }");
    EXPECT_NEAR(volume_of(frustum), (4 + 1 + 2) * kCubicMetre, 1);
    // To a point, which is no face.
    const Model tent = shape("Extrusion { spine [ 0 0 0, 0 3 0 ] scale [ 1 1, 0 0 ] }");
    EXPECT_NEAR(volume_of(tent), 4 * kCubicMetre, 1);
    EXPECT_EQ(shape("Extrusion { beginCap FALSE endCap FALSE }").faces.size(), 4u);
    // Upside down, and twisted about its spine by a right angle, are as large.
    EXPECT_NEAR(volume_of(shape("Extrusion { spine [ 0 0 0, 0 -1 0 ] }")), 4 * kCubicMetre, 1);
    EXPECT_NEAR(volume_of(shape("Extrusion { orientation 0 1 0 1.5707963 }")), 4 * kCubicMetre, 1e3);
}

// A square tube of side 0.2 around a regular polygon: by Pappus about its area times the way of its middle; with sections in the
// planes that halve the corners, exactly that of the prisms between them.
TEST(VrmlGeometry, AClosedSpineIsARing) {
    std::string spine;
    constexpr int kCorners = 24;
    for (int i = 0; i <= kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * (i % kCorners) / kCorners;
        spine += std::to_string(std::cos(angle)) + " 0 " + std::to_string(-std::sin(angle)) + ", ";
    }
    const Model ring =
        shape("Extrusion { crossSection [ 0.1 0.1, 0.1 -0.1, -0.1 -0.1, -0.1 0.1, 0.1 0.1 ] spine [" + spine + "] }");
    EXPECT_EQ(ring.faces.size(), 4u * kCorners) << "no caps";
    EXPECT_NEAR(openness_of(ring), 0, 1);
    EXPECT_NEAR(volume_of(ring) / kCubicMetre, 0.04 * 2 * std::numbers::pi, 0.04 * 2 * std::numbers::pi * 0.02);
    expect_near(bounds_of(ring, ring.objects[0]).size(), {2200, 2200, 200}, 20);
}

// The same square, told in every way that X3D has.
TEST(VrmlGeometry, X3dSetsAreTheSameSurface) {
    const std::string head = "#X3D V3.3 utf8\nPROFILE Immersive\n";
    const std::string four = "coord Coordinate { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] }";
    const std::string strip = "coord Coordinate { point [ 0 1 0, 0 0 0, 1 1 0, 1 0 0 ] }";
    for (const std::string& square : {
             "IndexedTriangleSet { " + four + " index [ 0 1 2 0 2 3 ] }",
             "IndexedTriangleStripSet { " + strip + " index [ 0 1 2 3 -1 ] }",
             "IndexedTriangleFanSet { " + four + " index [ 0 1 2 3 -1 ] }",
             "IndexedQuadSet { " + four + " index [ 0 1 2 3 ] }",
             "QuadSet { " + four + " }",
             "TriangleStripSet { " + strip + " stripCount [ 4 ] }",
             "TriangleFanSet { " + four + " fanCount [ 4 ] }",
             std::string("TriangleSet { coord Coordinate { point [ 0 0 0, 1 0 0, 1 1 0, 0 0 0, 1 1 0, 0 1 0 ] } }"),
             "IndexedFaceSet { " + four + " coordIndex [ 0 1 2 3 ] }",
         }) {
        const Model model = shape(square, head);
        Point3 sum;
        for (const ModelFace& face : model.faces) sum = sum + area_vector(ring_of(model, face));
        expect_near(sum, {0, -kSquareMetre, 0}, 1e-6);
        EXPECT_NEAR(area_of(model), kSquareMetre, 1e-6) << square;
    }
}

TEST(VrmlGeometry, FlatThingsOfX3dFaceWhoLooks) {
    const std::string head = "#X3D V3.3 utf8\n";
    const double ring = 16 * std::sin(std::numbers::pi / 16);  // of a radius of 1
    const std::pair<std::string, double> flat[] = {{"Rectangle2D { size 3 2 }", 6},
                                                   {"Rectangle2D {}", 4},
                                                   {"Disk2D {}", ring},
                                                   {"Disk2D { innerRadius 1 outerRadius 2 }", 3 * ring},
                                                   {"TriangleSet2D { vertices [ 0 0 1 0 0 1, 2 2, 4 2, 4 4 ] }", 2.5}};
    for (const auto& [geometry, area] : flat) {
        const Model model = shape(geometry, head);
        Point3 sum;
        for (const ModelFace& face : model.faces) sum = sum + area_vector(ring_of(model, face));
        expect_near(sum, {0, -area * kSquareMetre, 0}, 1e-3);
        EXPECT_NEAR(area_of(model), area * kSquareMetre, 1e-3) << geometry;
        EXPECT_FALSE(model.objects[0].one_sided);
    }
}

TEST(VrmlGeometry, LinesAndTextsAreNamedAsLeftOut) {
    const ReadWorld world =
        read_world(kVrml97 +
                   "Shape { geometry Box {} }\nShape { geometry IndexedLineSet {} }\nShape { geometry PointSet {} }\n"
                   "Shape { geometry Text { string \"sink\" } }\nShape { geometry IndexedLineSet {} }");
    EXPECT_EQ(in_language(world.notes, "en"),
              (std::vector<std::string>{"left out: IndexedLineSet, which has no faces (2 times, first in line 3)",
                                        "left out: PointSet, which has no faces (line 4)", "left out: Text (line 5)"}));
}

}  // namespace
}  // namespace tactics::geometry_test
