// SPDX-License-Identifier: Apache-2.0
// X3D in its two syntaxes.
#include <gtest/gtest.h>

#include "tests/tactics/readers/vrml/worlds.h"

namespace tactics::x3d_test {
namespace {

using namespace tests;

ReadWorld xml(const std::string& scene, const std::string& head = "") {
    ReadWorld read = read_world(
        "<?xml version=\"1.0\"?>\n<!DOCTYPE X3D PUBLIC \"ISO//Web3D//DTD X3D 3.3//EN\" \"x3d-3.3.dtd\">\n"
        "<X3D version='3.3' profile='Immersive'><head>" +
            head + "<meta name='title' content='x.x3d'/></head>\n<Scene>" + scene + "</Scene></X3D>",
        "test.x3d");
    expect_sound(read.model);
    return read;
}
ReadWorld classic(const std::string& scene) {
    ReadWorld read = read_world(
        "#X3D V3.3 utf8\nPROFILE Immersive\nCOMPONENT CADGeometry:1\nCOMPONENT HAnim : 2\n"
        "META \"title\" \"x\"\n" +
            scene,
        "test.x3dv");
    expect_sound(read.model);
    return read;
}

TEST(X3d, BothSyntaxesAreTheSameWorld) {
    const Model a =
        xml("<WorldInfo title='t'/><Transform DEF='Tisch' translation='1 2 3' rotation='0 0 1 0.5'>\n"
            "<Shape DEF='Platte'><Appearance><Material diffuseColor='1 0 0'/></Appearance><Box size='2, 0.1, 1'/></Shape>\n"
            "<Transform translation='0 1 0'><Shape USE='Platte'/></Transform>\n"
            "<Shape><IndexedFaceSet solid='false' coordIndex='0 1 2 -1'><Coordinate DEF='c' point='0 0 0 1 0 0 0 1 "
            "0'/></IndexedFaceSet></Shape>\n"
            "<Shape><IndexedTriangleSet index='0 1 2'><Coordinate USE='c'/></IndexedTriangleSet></Shape>\n"
            "</Transform>\n"
            "<Switch whichChoice='1'><Group/><Group DEF='Zweite'><Shape><Sphere radius='0.5'/></Shape></Group></Switch>")
            .model;
    const Model b = classic(
                        "WorldInfo { title \"t\" } DEF Tisch Transform { translation 1 2 3 rotation 0 0 1 0.5 children [\n"
                        "DEF Platte Shape { appearance Appearance { material Material { diffuseColor 1 0 0 } } geometry Box { "
                        "size 2 0.1 1 } }\n"
                        "Transform { translation 0 1 0 children USE Platte }\n"
                        "Shape { geometry IndexedFaceSet { solid false coordIndex [ 0 1 2 -1 ] coord DEF c Coordinate { point [ "
                        "0 0 0 1 0 0 0 1 0 ] } } }\n"
                        "Shape { geometry IndexedTriangleSet { index [ 0 1 2 ] coord USE c } } ] }\n"
                        "Switch { whichChoice 1 children [ Group {} DEF Zweite Group { children Shape { geometry Sphere { radius "
                        "0.5 } } } ] }")
                        .model;
    EXPECT_EQ(names_of(a), "Tisch(Platte Platte - -) Zweite");
    EXPECT_EQ(names_of(a), names_of(b));
    EXPECT_EQ(a.title, "t");
    EXPECT_EQ(b.title, "t");
    ASSERT_EQ(a.corners, b.corners);
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    for (std::size_t i = 0; i < a.vertices.size(); ++i) EXPECT_EQ(a.vertices[i], b.vertices[i]);
    for (std::size_t i = 0; i < a.objects.size(); ++i) {
        EXPECT_EQ(a.objects[i].primitive, b.objects[i].primitive);
        EXPECT_EQ(a.objects[i].one_sided, b.objects[i].one_sided);
    }
}

TEST(X3d, AUnitOfLengthIsHonoured) {
    const std::string box = "<Shape><Box size='1 2 3'/></Shape>";
    const Model inches = xml(box, "<unit category='length' name='inch' conversionFactor='0.0254'/>").model;
    expect_near(bounds_of(inches, inches.objects[0]).size(), {25.4, 76.2, 50.8}, 1e-9);
    const Model degrees = classic(
                              "UNIT angle degree 0.017453292519943295\nUNIT length mm 0.001\n"
                              "Transform { rotation 0 0 1 90 children Shape { geometry Box { size 1 2 3 } } }")
                              .model;
    expect_near(bounds_of(degrees, degrees.objects[0]).size(), {2, 3, 1}, 1e-9);
    EXPECT_NE(refusal_of("<X3D><head>\n<unit category='length' conversionFactor='0'/></head></X3D>").find(":2:"),
              std::string::npos);
}

TEST(X3d, NamesComeFromWhatNamesThings) {
    EXPECT_EQ(names_of(xml("<Anchor description='the door'><Shape><Box/></Shape></Anchor>"
                           "<CADAssembly name='car'><CADPart name='wheel'><CADFace><Shape "
                           "containerField='shape'><Box/></Shape></CADFace></CADPart>"
                           "<CADPart name='12'><Shape><Box/></Shape></CADPart></CADAssembly>"
                           "<HAnimHumanoid name='Ann'><HAnimJoint name='root' containerField='skeleton'><HAnimSegment "
                           "name='hips'><Shape><Box/></Shape>"
                           "</HAnimSegment></HAnimJoint><HAnimJoint USE='nobody' containerField='joints'/></HAnimHumanoid>"
                           "<Group><MetadataString name='title' value='\"a lamp\"'/><Shape><Sphere/></Shape></Group>"
                           "<Group DEF='K&#252;che'><Shape><Sphere/></Shape></Group>")
                           .model),
              "the door car(wheel 12) Ann(root(hips)) a lamp Küche");
}

TEST(X3d, PrototypesInXml) {
    const Model model =
        xml("<ProtoDeclare name='Leg'><ProtoInterface>\n"
            "<field name='at' type='SFVec3f' accessType='inputOutput' value='0 0 0'/>\n"
            "<field name='inside' type='MFNode' accessType='initializeOnly'><Shape><Sphere/></Shape></field>\n"
            "</ProtoInterface><ProtoBody><Transform><IS><connect nodeField='translation' protoField='at'/>\n"
            "<connect nodeField='children' protoField='inside'/></IS></Transform></ProtoBody></ProtoDeclare>\n"
            "<ProtoInstance name='Leg' DEF='first'><fieldValue name='at' value='1 2 3'/></ProtoInstance>\n"
            "<ProtoInstance name='Leg'><fieldValue name='inside'><Shape><Box/></Shape></fieldValue></ProtoInstance>")
            .model;
    EXPECT_EQ(names_of(model), "first Leg");
    EXPECT_EQ(model.objects[0].primitive, Primitive::sphere);
    expect_near(model.objects[0].frame.middle, {1000, -3000, 2000}, 1e-9);
    EXPECT_EQ(model.objects[1].primitive, Primitive::box);
}

TEST(X3d, WhatIsLeftOutHasItsLine) {
    const ReadWorld read =
        xml("<Shape><Box/></Shape>\n<Inline url='\"engine.x3d\" \"http://x/engine.x3d\"'/>\n"
            "<ExternProtoDeclare name='Lamp' url='\"l.x3d\"'/><ProtoInstance name='Lamp'/>\n"
            "<Shape><Text string='\"a\"'/></Shape>\n<Shape><Box/></Shape>\n<Group visible='false'><Shape><Box/></Shape></Group>\n"
            "<Fancy/><Viewpoint/><DirectionalLight/>");
    EXPECT_EQ(read.model.faces.size(), 12u);
    ASSERT_EQ(read.notes.size(), 5u);
    EXPECT_EQ(read.notes[0].english(), "left out: Inline of \"engine.x3d\": no other file is read; take it by itself (line 5)");
    EXPECT_NE(read.notes[1].english().find("Lamp"), std::string::npos);
    EXPECT_EQ(read.notes[2].english(), "left out: Text (line 7)");
    EXPECT_EQ(read.notes[3].english(), "left out: what is not visible (line 9)");
    EXPECT_EQ(read.notes[4].english(), "left out: Fancy, a node that is not known here (line 10)");
}

TEST(X3d, EntitiesDoNotGrowAndDepthIsBounded) {
    std::string laughs = "<!DOCTYPE X3D [<!ENTITY a 'ha ha ha ha ha ha ha ha ha ha '>";
    for (char c = 'b'; c < 'k'; ++c) {
        laughs += std::string("<!ENTITY ") + c + " '";
        for (int i = 0; i < 10; ++i) laughs += std::string("&") + static_cast<char>(c - 1) + ";";
        laughs += "'>";
    }
    EXPECT_FALSE(refusal_of(laughs + "]><X3D><Scene><WorldInfo title='&j;'/></Scene></X3D>").empty());
    EXPECT_FALSE(refusal_of("<!DOCTYPE X3D [<!ENTITY x SYSTEM '/etc/passwd'>]><X3D><Scene>&x;</Scene></X3D>").empty());
    std::string deep = "<X3D><Scene>";
    for (int i = 0; i < 8000; ++i) deep += "<Group>\n";
    EXPECT_NE(refusal_of(deep).find("nested"), std::string::npos);
    EXPECT_NE(refusal_of("<X3D><Scene>\n<Shape><IndexedFaceSet coordIndex='0 1 2'><Coordinate point='0 0 0\n1 NaN 0 0 1 0'/>"
                         "</IndexedFaceSet></Shape></Scene></X3D>")
                  .find("test.wrl:2: \"NaN\" is no number"),
              std::string::npos);
    EXPECT_NE(refusal_of("<html/>").find("no X3D"), std::string::npos);
}

}  // namespace
}  // namespace tactics::x3d_test
