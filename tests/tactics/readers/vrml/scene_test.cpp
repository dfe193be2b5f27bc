// SPDX-License-Identifier: Apache-2.0
// Groups, names, USE and PROTO of VRML97.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/tactics/readers/vrml/worlds.h"

namespace tactics::scene_test {
namespace {

using namespace tests;

ReadWorld scene(const std::string& text) {
    ReadWorld world = read_world(kVrml97 + text);
    expect_sound(world.model);
    return world;
}
std::string names(const std::string& text) { return names_of(scene(text).model); }

TEST(VrmlScene, NamesAndHierarchyAreKept) {
    EXPECT_EQ(names("DEF Desk Transform { children [ DEF Drawer Group { children Shape { geometry Box {} } }\n"
                    "Transform { children [ DEF Leg Shape { geometry Box {} } Shape { geometry Sphere {} } ] } ] }\n"
                    "DEF Empty Group {} DEF Light PointLight {} Shape { geometry DEF Ball Sphere {} }"),
              "Desk(Drawer Leg -) Ball");
    EXPECT_EQ(
        names("DEF Küche Group { children Shape { geometry Box {} } } DEF 台所 Group { children Shape { geometry Box {} } }"),
        "Küche 台所");
    EXPECT_EQ(names("Anchor { description \"the door\" children Shape { geometry Box {} } }"), "the door");
    // As 3ds Max has it: the mesh's own name says nothing that the group's does not.
    EXPECT_EQ(names("DEF Board Transform { children [ Shape { geometry DEF Board-FACES Box {} } ] }"), "Board");
}

// A viewpoint looks along -z of its own; y up in a file is z up here.
TEST(VrmlScene, TheFirstViewpointIsKept) {
    const std::string box = "Shape { geometry Box {} }";
    const auto from = [](const Model& model) { return model.viewed_from; };
    EXPECT_EQ(from(scene(box).model), Point3{});
    EXPECT_NEAR(length_of(from(scene("Viewpoint {} " + box).model) - Point3{0, -1, 0}), 0, 1e-9);
    EXPECT_NEAR(
        length_of(from(scene("Viewpoint { orientation 1 0 0 -1.570796326794897 } Viewpoint {} " + box).model) - Point3{0, 0, 1}),
        0, 1e-9);
    EXPECT_NEAR(
        length_of(from(scene("Transform { scale 5 5 5 rotation 0 1 0 1.570796326794897 children Viewpoint {} } " + box).model) -
                  Point3{1, 0, 0}),
        0, 1e-9);
    const Model old =
        read_world("#VRML V1.0 ascii\nSeparator { PerspectiveCamera { orientation 0 1 0 1.570796326794897 } Cube {} }").model;
    EXPECT_NEAR(length_of(from(old) - Point3{1, 0, 0}), 0, 1e-9);
}

TEST(VrmlScene, ANameInAnotherEncodingIsTurnedAndNoted) {
    const ReadWorld world = scene(
        "DEF K\xfc"
        "che Group { children Shape { geometry Box {} } }");
    EXPECT_EQ(world.model.objects[0].name, "Küche");
    EXPECT_EQ(in_language(world.notes, "en"), std::vector<std::string>{"names that are not UTF-8 are taken as Latin-1 (line 2)"});
}

TEST(VrmlScene, ALongNameIsCutBetweenLetters) {
    std::string name;
    for (int i = 0; i < 150; ++i) name += "é";
    const std::string cut = scene("DEF x" + name + " Shape { geometry Box {} }").model.objects[0].name;
    EXPECT_EQ(cut.size(), 199u);
    EXPECT_TRUE(cut.ends_with("é"));
}

// What the standard says of Transform, done step by step on a point.
TEST(VrmlScene, ATransformIsComposedAsTheStandardHasIt) {
    const Model model = scene(
                            "Transform { center 1 2 3 translation 10 0 0 rotation 0 0 1 1.5707963267948966 scale 2 3 4\n"
                            "scaleOrientation 0 1 0 1.5707963267948966\n"
                            "children Transform { translation 0 5 0 children Shape { geometry IndexedFaceSet {\n"
                            "coord Coordinate { point [ 0 0 0, 1 0 0, 0 1 0 ] } coordIndex [ 0 1 2 ] } } } }")
                            .model;
    const auto expected = [](double x, double y, double z) {
        y += 5;  // the inner translation
        x -= 1, y -= 2, z -= 3;
        // About y by a right angle x becomes -z; scaled in the turned axes x is scaled by 4 and z by 2.
        x *= 4, y *= 3, z *= 2;
        const double turned_x = -y, turned_y = x;
        x = turned_x + 1 + 10, y = turned_y + 2, z = z + 3;
        return Point3{1000 * x, -1000 * z, 1000 * y};
    };
    expect_near(model.vertices[0], expected(0, 0, 0), 1e-6);
    expect_near(model.vertices[1], expected(1, 0, 0), 1e-6);
    expect_near(model.vertices[2], expected(0, 1, 0), 1e-6);
}

TEST(VrmlScene, WhatIsMirroredStillLooksOutwards) {
    for (const char* const scale : {"1 1 1", "-1 1 1", "-1 -1 1", "-1 -2 -3"})
        EXPECT_GT(volume_of(scene(std::string("Transform { scale ") + scale + " children Shape { geometry Box {} } }").model), 0);
}

TEST(VrmlScene, APrimitiveKeepsItsFrameInTheWorld) {
    const Model model = scene(
                            "Transform { translation 1 2 3 rotation 0 0 1 1.5707963267948966 scale 1 2 1\n"
                            "children Shape { geometry Cylinder { radius 0.1 height 1 } } }")
                            .model;
    const ModelObject& object = model.objects[0];
    EXPECT_EQ(object.primitive, Primitive::cylinder);
    expect_near(object.frame.middle, {1000, -3000, 2000}, 1e-9);
    expect_near(object.frame.c, {-1000, 0, 0}, 1e-9);
    expect_near(bounds_of(model, object).middle(), object.frame.middle, 1e-9);
}

TEST(VrmlScene, AThingUsedAgainIsAnObjectAgain) {
    const Model model = scene(
                            "DEF A Transform { translation 1 0 0 children DEF Leg Shape { geometry Box { size 1 1 1 } } }\n"
                            "DEF B Transform { translation 5 0 0 children USE Leg }")
                            .model;
    EXPECT_EQ(names_of(model), "A(Leg) B(Leg)");
    expect_near(bounds_of(model, model.objects[1]).middle(), {1000, 0, 0}, 1e-9);
    expect_near(bounds_of(model, model.objects[3]).middle(), {5000, 0, 0}, 1e-9);
    // The latest of a name counts.
    EXPECT_EQ(scene("DEF A Shape { geometry Box {} } DEF A Shape { geometry Sphere {} } USE A").model.objects[2].primitive,
              Primitive::sphere);
}

TEST(VrmlScene, SwitchAndLodShowOne) {
    const std::string three =
        "[ DEF a Shape { geometry Box {} } DEF b Shape { geometry Box {} } DEF c Shape { geometry Box {} } ]";
    EXPECT_EQ(names("Switch { whichChoice 1 choice " + three + " }"), "b");
    EXPECT_EQ(names("LOD { range [ 1, 2 ] level " + three + " }"), "a") << "the finest";
    const ReadWorld hidden = scene("DEF d Shape { geometry Box {} } Switch { choice " + three + " }");
    EXPECT_EQ(names_of(hidden.model), "d");
    EXPECT_EQ(in_language(hidden.notes, "en"), std::vector<std::string>{"left out: what a Switch does not show (line 2)"});
    EXPECT_EQ(names("Collision { proxy Shape { geometry Sphere {} } children DEF x Shape { geometry Box {} } }"), "x");
    EXPECT_EQ(names("Billboard { children DEF x Shape { geometry Box {} } }"), "x");
}

TEST(VrmlScene, AProtoIsMadeWithWhatItsInstanceSays) {
    const std::string leg =
        "PROTO Leg [ field SFVec3f at 0 0 0 exposedField MFNode inside [] eventIn SFBool on ] {\n"
        "  Transform { translation IS at children IS inside }\n  Shape { geometry Sphere {} }\n}\n";
    const Model model = scene(leg +
                              "Leg { at 1 2 3 inside Shape { geometry Box {} } } DEF Second Leg { inside [ Leg { at 0 1 0 "
                              "inside DEF ball Shape { geometry Sphere {} } } ] }")
                            .model;
    EXPECT_EQ(names_of(model), "Leg Second(Leg(ball))") << "what stands behind the first node is not shown";
    expect_near(model.objects[0].frame.middle, {1000, -3000, 2000}, 1e-9);
    expect_near(model.objects[3].frame.middle, {0, 0, 1000}, 1e-9);
    // A PROTO in a PROTO, whose value comes from the outermost.
    EXPECT_EQ(
        scene("PROTO Outer [ field SFVec3f size 2 2 2 ] { PROTO Inner [ field SFVec3f size 1 1 1 ] { Box { size IS size } }\n"
              "Shape { geometry Inner { size IS size } } } Outer { size 4 4 4 }")
            .model.objects[0]
            .frame.a.x,
        2000);
    // Names within a PROTO are its own.
    EXPECT_EQ(names("DEF x Shape { geometry Box {} } PROTO P [] { DEF x Shape { geometry Sphere {} } } P {} DEF y Group { "
                    "children USE x }"),
              "x x y(x)");
}

TEST(VrmlScene, WhatIsNotOfItsSurfaceIsReadOver) {
    const ReadWorld world = scene(
        "WorldInfo { title \"t\" info [ \"a\" \"b\" ] } NavigationInfo { type [ \"EXAMINE\", \"ANY\" ] }\n"
        "DEF S Script { field SFNode self USE S eventIn SFTime go field MFFloat f [ 1 2 ] url \"javascript: function go() { }\" "
        "}\n"
        "DEF T TimeSensor { cycleInterval 2 } DEF I PositionInterpolator { key [ 0 1 ] keyValue [ 0 0 0, 1 1 1 ] }\n"
        "ROUTE T.fraction_changed TO I.set_fraction\n"
        "Shape { appearance Appearance { material Material { diffuseColor 1 0 0 } texture PixelTexture { image 1 1 1 0xFF } }\n"
        "geometry Box { size 1, 1, 1 } } # the end");
    EXPECT_TRUE(world.notes.empty()) << world.notes[0].english();
    EXPECT_EQ(world.model.title, "t");
    EXPECT_EQ(world.model.objects.size(), 1u);
}

TEST(VrmlScene, UnknownNodesDoNotHarmTheRest) {
    const ReadWorld world = scene(
        "Fancy { colour 1 2 3 words [ \"a\", B ] inner Odd { x TRUE } }\n"
        "DEF f Flower { children [ DEF x Shape { geometry Box {} } ] }\n"
        "Viewpoint { centerOfRotation 0 0 0 } Shape { geometry Knot { turns 3 } }");
    EXPECT_EQ(names_of(world.model), "f(x)");
    EXPECT_EQ(in_language(world.notes, "en"),
              (std::vector<std::string>{"left out: Fancy, a node that is not known here (line 2)",
                                        "left out: Flower, a node that is not known here; what is in it is kept (line 3)",
                                        "left out: Knot, a geometry that is not known here (line 4)"}));
}

TEST(VrmlScene, WhatIsNotOfTheStandardAndOftenWrittenIsRead) {
    // A PROTO among nodes, the matrix of VRML 1.0, a node in no field.
    const Model model =
        scene(
            "Group { children [ PROTO P [] { Shape { geometry Box {} } } P {} ] }\n"
            "MatrixTransform { matrix 0 2 0 0 -1 0 0 0 0 0 1 0 2 0 3 1 children [ DEF b Shape { geometry Box {} } ] }\n"
            "Group { DEF 3.5-inch Shape { geometry Box {} } }")
            .model;
    EXPECT_EQ(names_of(model), "P b 3.5-inch");
    expect_near(bounds_of(model, model.objects[1]).middle(), {2000, -3000, 0}, 1e-9);
    expect_near(bounds_of(model, model.objects[1]).size(), {2000, 2000, 4000}, 1e-9);
}

TEST(VrmlScene, NotesAreFew) {
    std::string text = "Shape { geometry Box {} }";
    for (int i = 0; i < 100; ++i) text += " Fancy" + std::to_string(i) + " {}";
    const ReadWorld world = scene(text);
    ASSERT_EQ(world.notes.size(), 21u);
    EXPECT_EQ(world.notes.back().english(), "left out: 80 more of other kinds");
}

TEST(VrmlScene, NoOtherFileIsOpened) {
    const ReadWorld world = scene(
        "Shape { geometry Box {} } Inline { url \"/etc/passwd\" } Inline { url [ \"test.wrl\" ] }\n"
        "EXTERNPROTO Lamp [ field SFFloat x ] [ \"lamps.wrl#Lamp\" ] Lamp { x 1 }");
    ASSERT_EQ(world.notes.size(), 3u);
    EXPECT_NE(world.notes[0].english().find("/etc/passwd"), std::string::npos);
    EXPECT_NE(world.notes[2].english().find("Lamp"), std::string::npos);
    // A file of such alone says why there is nothing.
    EXPECT_NE(refusal_of(kVrml97 + "Inline { url \"desk.wrl\" }").find("desk.wrl"), std::string::npos);
}

}  // namespace
}  // namespace tactics::scene_test
