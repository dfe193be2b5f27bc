// SPDX-License-Identifier: Apache-2.0
// VRML 1.0 and Open Inventor: what nodes leave for those behind them.
#include <gtest/gtest.h>

#include "tests/tactics/readers/vrml/worlds.h"

namespace tactics::state_walk_test {
namespace {

using namespace tests;

const std::string kVrml1 = "#VRML V1.0 ascii\n";

ReadWorld world(const std::string& text, const std::string& head = kVrml1) {
    ReadWorld read = read_world(head + text);
    expect_sound(read.model);
    return read;
}
Point3 middle(const Model& model, std::size_t object = 0) { return bounds_of(model, model.objects[object]).middle(); }

TEST(Vrml1, PlacesAddUpUntilTheirSeparatorEnds) {
    const Model model = world(
                            "Separator {\n"
                            "  Translation { translation 1 0 0 }\n"
                            "  DEF a Cube {}\n"
                            "  Separator { Translation { translation 0 2 0 } DEF b Cube {} }\n"
                            "  TransformSeparator { Translation { translation 0 0 3 } DEF c Cube {} }\n"
                            "  Group { Translation { translation 10 0 0 } DEF d Cube {} }\n"
                            "  DEF e Cube {}\n"
                            "}")
                            .model;
    EXPECT_EQ(names_of(model), "a b c d e");
    expect_near(middle(model, 0), {1000, 0, 0}, 1e-9);
    expect_near(middle(model, 1), {1000, 0, 2000}, 1e-9);
    expect_near(middle(model, 2), {1000, -3000, 0}, 1e-9);
    expect_near(middle(model, 3), {11000, 0, 0}, 1e-9);
    expect_near(middle(model, 4), {11000, 0, 0}, 1e-9);
}

// One Transform is its parts in a row, and the matrix that they make.
TEST(Vrml1, TransformsTurnsAndMatricesAgree) {
    const std::string cube = "Cube { width 1 height 2 depth 3 } }";
    const std::string quarter = "1.5707963267948966";
    const Model whole =
        world("Separator { Transform { translation 1 2 3 rotation 0 0 1 " + quarter + " scaleFactor 2 1 1 center 1 0 0 } " + cube)
            .model;
    const Model parts =
        world("Separator { Translation { translation 1 2 3 } Translation { translation 1 0 0 } Rotation { rotation 0 0 1 " +
              quarter + " } Scale { scaleFactor 2 1 1 } Translation { translation -1 0 0 } " + cube)
            .model;
    const Model axis = world("Separator { Translation { translation 2 2 3 } RotationXYZ { axis Z angle " + quarter +
                                 " } Scale { scaleFactor 2 1 1 } Translation { translation -1 0 0 } " + cube,
                             "#Inventor V2.1 ascii\n")
                           .model;
    // Rows: where x, y, z and the origin go to.
    const Model matrix = world("Separator { MatrixTransform { matrix 0 2 0 0 -1 0 0 0 0 0 1 0 2 0 3 1 } " + cube).model;
    ASSERT_EQ(whole.vertices.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i) {
        expect_near(whole.vertices[i], parts.vertices[i], 1e-9);
        expect_near(whole.vertices[i], axis.vertices[i], 1e-9);
        expect_near(whole.vertices[i], matrix.vertices[i], 1e-9);
    }
}

TEST(Vrml1, FacesTakeThePointsAndHintsBeforeThem) {
    const std::string points = "Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] }",
                      face = "IndexedFaceSet { coordIndex [ 0,1,2,3,-1 ] }";
    const Model plain = world("Separator { " + points + face + "}").model;
    EXPECT_FALSE(plain.objects[0].one_sided) << "nothing is said of its sides";
    EXPECT_NEAR(area_vector(ring_of(plain, plain.faces[0])).y, -1e6, 1);
    const Model solid =
        world("Separator { ShapeHints { vertexOrdering COUNTERCLOCKWISE shapeType SOLID } " + points + face + "}").model;
    EXPECT_TRUE(solid.objects[0].one_sided);
    const Model clockwise =
        world("Separator { ShapeHints { vertexOrdering CLOCKWISE shapeType SOLID faceType CONVEX } " + points + face + "}").model;
    EXPECT_NEAR(area_vector(ring_of(clockwise, clockwise.faces[0])).y, 1e6, 1);
    // Points stay those of the Separator.
    const ReadWorld after =
        world("Separator { " + points + " Separator { Coordinate3 { point [ 0 0 0, 2 0 0, 2 2 0, 0 2 0 ] } } " + face + "}");
    EXPECT_NEAR(area_of(after.model), 1e6, 1);
}

TEST(Vrml1, RoundThingsHaveTheirParts) {
    EXPECT_EQ(world("Cylinder {}").model.faces.size(), 34u);
    EXPECT_EQ(world("Cylinder { parts ALL radius 2 }").model.faces.size(), 34u);
    EXPECT_EQ(world("Cylinder { parts SIDES }").model.faces.size(), 32u);
    EXPECT_EQ(world("Cylinder { parts (SIDES | BOTTOM) }").model.faces.size(), 33u);
    EXPECT_EQ(world("Cone { parts (SIDES|BOTTOM) }").model.faces.size(), 33u);
    EXPECT_EQ(world("Cone { parts BOTTOM }").model.faces.size(), 1u);
    const Model ball = world("DEF Ball Sphere { radius 3 }").model;
    EXPECT_EQ(ball.objects[0].primitive, Primitive::sphere);
    EXPECT_NEAR(length_of(ball.objects[0].frame.b), 3000, 1e-9);
    EXPECT_GT(volume_of(ball), 0);
}

TEST(Vrml1, SwitchLodAndLinks) {
    const std::string three = "DEF a Cube {} DEF b Cube {} DEF c Cube {} }";
    EXPECT_EQ(names_of(world("Separator { Switch { whichChild 1 " + three + "}").model), "b");
    EXPECT_EQ(names_of(world("Separator { Switch { whichChild -3 " + three + "}").model), "a b c");
    EXPECT_EQ(names_of(world("Separator { LOD { range [ 1, 2 ] center 0 0 0 " + three + "}").model), "a");
    EXPECT_EQ(names_of(world("WWWAnchor { name \"http://x\" description \"a door\" Cube {} }").model), "a door");
    const ReadWorld other = world("Separator { Cube {}\nWWWInline { name \"lamp.wrl\" } }");
    ASSERT_EQ(other.notes.size(), 1u);
    EXPECT_NE(other.notes[0].english().find("lamp.wrl"), std::string::npos);
}

TEST(Vrml1, WhatIsUsedAgainStandsWhereItIsUsed) {
    const Model model =
        world(
            "Separator { DEF Leg Separator { Cube { width 1 height 1 depth 1 } Translation { translation 0 9 0 } }\n"
            "Translation { translation 4 0 0 } USE Leg DEF Far Translation { translation 1 0 0 } USE Far Cube {} }")
            .model;
    EXPECT_EQ(names_of(model), "Leg Leg -");
    expect_near(middle(model, 1), {4000, 0, 0}, 1e-9);
    expect_near(middle(model, 2), {6000, 0, 0}, 1e-9);
}

TEST(Vrml1, LooksAreReadOverAndUnknownNodesKeepWhatIsInThem) {
    const ReadWorld read = world(
        "Separator { Info { string \"by hand\" } Material { diffuseColor [ 1 0 0, 0 1 0 ] } PerspectiveCamera { position 0 0 5 "
        "}\n"
        "DirectionalLight { on TRUE } MaterialBinding { value PER_FACE_INDEXED } Texture2 { filename \"a.png\" wrapS REPEAT }\n"
        "FontStyle { size 10 } AsciiText { string \"hello\" }\n"
        "Fancy { fields [ SFFloat x, isA ] x 1 Translation { translation 1 0 0 } DEF in Cube {} }\n"
        "DEF out Cube {} }");
    EXPECT_EQ(names_of(read.model), "in out");
    expect_near(middle(read.model, 1), {0, 0, 0}, 1e-9);
    EXPECT_EQ(in_language(read.notes, "en"),
              (std::vector<std::string>{"left out: AsciiText, which has no faces (line 4)",
                                        "left out: Fancy, a node that is not known here; what is in it is kept (line 5)"}));
}

TEST(Vrml1, InventorHasUnitsAndFaceSets) {
    const Model model = world(
                            "Separator { Units { units MILLIMETERS } Coordinate3 { point [ 0 0 0, 9 0 0, 9 0 -9, 0 0 -9, 0 0 0, "
                            "1 0 0, 1 1 0 ] }\n"
                            "FaceSet { numVertices [ 4, -1 ] } Units { units INCHES } Cube { width 1 height 1 depth 1 } }",
                            "#Inventor V2.0 ascii\n")
                            .model;
    ASSERT_EQ(model.objects.size(), 2u);
    EXPECT_EQ(model.objects[0].count, 2u);
    EXPECT_NEAR(area_vector(ring_of(model, model.faces[0])).z, 81, 1e-9);
    expect_near(bounds_of(model, model.objects[1]).size(), {25.4, 25.4, 25.4}, 1e-9);
}

}  // namespace
}  // namespace tactics::state_walk_test
