// SPDX-License-Identifier: Apache-2.0
// Bad worlds: one line of what is wrong and where, or a model and a note of what is missing.
#include <gtest/gtest.h>
#include <zlib.h>

#include "tactics/job/holds.h"
#include "tactics/measure/random.h"
#include "tactics/readers/gzip.h"
#include "tactics/readers/model.h"
#include "tests/tactics/readers/vrml/worlds.h"

namespace tactics::hostile_test {
namespace {

using namespace tests;

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

std::string packed(const std::string& text) {
    z_stream stream{};
    EXPECT_EQ(deflateInit2(&stream, 1, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
    std::string bytes(deflateBound(&stream, text.size()) + 32, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_out = static_cast<uInt>(bytes.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    bytes.resize(stream.total_out);
    deflateEnd(&stream);
    return bytes;
}

// All that there is, in little.
const std::string kAll = kVrml97 + R"(PROTO Leg [ field SFVec3f at 0 0 0 field MFNode c [ Shape { geometry Cone { } } ] ] {
  Transform { translation IS at children IS c } }
DEF Tisch Transform { translation 1 0 0 rotation 0 1 0 .5 children [ # a comment, with a " in it
  DEF Platte Shape { geometry Box { size 1.2 0.04 0.8 } appearance Appearance { } }
  Leg { at 1e-1 -2 +3 } DEF L Leg { c [ USE Platte, Inline { url ["a.wrl" "b\".wrl"] } ] }
  Switch { whichChoice 0 choice [ LOD { level Shape { geometry Sphere { radius 2 } } range [ 1 ] } ] } ] }
Shape { geometry IndexedFaceSet { ccw FALSE coord DEF P Coordinate { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] }
  coordIndex [ 0 1 2 3 -1 0,2,3,-1 ] } }
Shape { geometry Extrusion { spine [ 0 0 0 0 1 0 1 2 0 ] scale [ 1 1 .5 .5 ] orientation [ 0 1 0 1 ] } }
Shape { geometry ElevationGrid { xDimension 2 zDimension 2 height [ 0 1 2 3 ] } }
DEF S Script { field SFNode n USE S eventIn SFBool b url "x" } ROUTE S.a TO L.b
)";
const std::string kAllOld = R"(#VRML V1.0 ascii
Separator { ShapeHints { vertexOrdering CLOCKWISE shapeType SOLID } DEF a Separator { Transform { translation 1 2 3 }
  Cylinder { parts (SIDES | TOP) radius 2 } } USE a Switch { whichChild 0 Cube { } } Coordinate3 { point [ 0 0 0 1 0 0 0 1 0 ] }
  IndexedFaceSet { coordIndex [ 0 1 2 -1 ] } MatrixTransform { matrix 1 0 0 0 0 1 0 0 0 0 1 0 5 5 5 1 } DEF b Sphere { } }
)";
const std::string kAllXml = R"(<?xml version="1.0" encoding="UTF-8"?>
<X3D version='3.3'><head><unit category='length' name='mm' conversionFactor='0.001'/></head><Scene>
<ProtoDeclare name='Leg'><ProtoInterface><field name='at' type='SFVec3f' accessType='inputOutput' value='0 0 0'/></ProtoInterface>
<ProtoBody><Transform><IS><connect nodeField='translation' protoField='at'/></IS><Shape><Box/></Shape></Transform></ProtoBody></ProtoDeclare>
<Transform DEF='T' rotation='0 0 1 1'><ProtoInstance name='Leg'><fieldValue name='at' value='1 2 3'/></ProtoInstance>
<Shape DEF='s'><IndexedTriangleStripSet index='0 1 2 3 -1'><Coordinate point='0 0 0 1 0 0 0 1 0 1 1 0'/></IndexedTriangleStripSet></Shape>
</Transform><Group USE='T'/><Switch whichChoice='0'><Shape USE='s'/></Switch></Scene></X3D>
)";

// A file that is cut or changed anywhere is read or refused, with its name and on one line.
void expect_survived(const std::string& bytes, int& read) {
    try {
        expect_sound(read_world(bytes, "bad.wrl").model);
        ++read;
    } catch (const Error& error) {
        const std::string what = error.what();
        ASSERT_TRUE(what.starts_with("bad.wrl")) << what;
        ASSERT_FALSE(has(what, "\n")) << what;
        ASSERT_LT(what.size(), 2000u) << what;
    }
}

TEST(VrmlHostile, WhatIsCutAnywhereIsReadOrRefused) {
    for (const std::string& whole : {kAll, kAllOld, kAllXml}) {
        expect_sound(read_world(whole).model);
        int read = 0;
        for (std::size_t size = 0; size < whole.size(); ++size) expect_survived(whole.substr(0, size), read);
        EXPECT_LT(read, static_cast<int>(whole.size() / 2));
        const std::string gz = packed(whole);
        for (std::size_t size = 2; size < gz.size(); ++size) {
            int none = 0;
            expect_survived(gz.substr(0, size), none);
            EXPECT_EQ(none, 0);
        }
    }
}

TEST(VrmlHostile, WhatIsChangedAnywhereIsReadOrRefused) {
    RandomNumbers random(20);
    constexpr std::string_view kMarks = "{}[]\"#,\\01-9.eE \n<>/='&;UDI";
    for (const std::string& whole : {kAll, kAllOld, kAllXml}) {
        int read = 0;
        for (int trial = 0; trial < 3000; ++trial) {
            std::string bytes = whole;
            for (std::size_t k = 0; k <= random.below(4); ++k) {
                const std::size_t at = random.below(bytes.size());
                if (trial % 3 == 0) bytes[at] = static_cast<char>(random.below(256));
                if (trial % 3 == 1) bytes[at] = kMarks[random.below(kMarks.size())];
                if (trial % 3 == 2) bytes.insert(at, bytes.substr(random.below(bytes.size()), random.below(40)));
            }
            expect_survived(bytes, read);
        }
        EXPECT_GT(read, 100);
    }
}

TEST(VrmlHostile, SyntaxIsRefusedWithItsLine) {
    const std::pair<std::string, std::string_view> bad[] = {
        {"Shape {\ngeometry Box { size [ 1 2 3 }", "test.wrl:3: \"}\" stands where a value should"},
        {"Shape { geometry Box { } ", "test.wrl:2: the file ends where"},
        {"\n\nGroup { children [ ", "test.wrl:4: \"[\" is never closed"},
        {"WorldInfo {\ntitle \"no end }", "test.wrl:3: a text begins with \" here and never ends"},
        {"Shape\ngeometry", "test.wrl:3: \"geometry\" stands where \"{\" should"},
        {"Shape { geometry Box {\nsize 1 2 } }", "test.wrl:3: size takes 3 numbers and has 2"},
        {"Shape { geometry Sphere {\nradius NaN } }", "test.wrl:3: \"NaN\" is no number, and radius takes numbers"},
        {"Shape { geometry Sphere { radius 1e999 } }", "test.wrl:2: \"1e999\" is no number"},
        {"Shape { geometry Sphere { radius 0 } }", "left out: Sphere with a size that is not over 0 (line 2)"},
        {"Shape { geometry Cylinder { height -1 } }", "left out: Cylinder with a size that is not over 0 (line 2)"},
        {"Shape { geometry IndexedFaceSet { coord Coordinate {\npoint [ 0 0 0, 1 nan 0 ] } coordIndex 0 } }",
         "test.wrl:3: \"nan\" is no number"},
        {"12 { }", "test.wrl:2: \"12\" stands where a node should"},
        {"Transform { translation 1e300 0 0 children Transform { translation 1e308 0 0 children Shape { geometry Box { } } } }",
         "test.wrl:2: a corner is too far away"},
        {"", "test.wrl: has no faces"},
        {"The quick brown fox.", "test.wrl:2: \"quick\" stands where \"{\" should"},
    };
    for (const auto& [text, why] : bad) EXPECT_TRUE(has(refusal_of(kVrml97 + text), why)) << refusal_of(kVrml97 + text);
}

TEST(VrmlHostile, WithinItselfIsNoEnd) {
    const ReadWorld world = read_world(kVrml97 + "DEF A Group { children [ Shape { geometry Box { } }\nUSE A ] }");
    EXPECT_EQ(world.model.faces.size(), 6u);
    EXPECT_EQ(in_language(world.notes, "en"),
              std::vector<std::string>{"left out: USE of \"A\" within itself, which would have no end (line 3)"});
    const ReadWorld nobody = read_world(kVrml97 + "Shape { geometry Box { } } USE B DEF B Group { }");
    EXPECT_EQ(in_language(nobody.notes, "en"),
              std::vector<std::string>{"left out: USE of \"B\", which is not defined before (line 2)"});
    // A PROTO is not known within itself.
    const ReadWorld proto = read_world(kVrml97 + "PROTO P [ ] { Group { children [ Shape { geometry Box { } } P { } ] } } P { }");
    EXPECT_EQ(proto.model.faces.size(), 6u);
    EXPECT_EQ(in_language(proto.notes, "en"), std::vector<std::string>{"left out: P, a node that is not known here (line 2)"});
    EXPECT_TRUE(has(refusal_of("#VRML V1.0 ascii\nDEF A Separator { USE A }"), "within itself"));
}

TEST(VrmlHostile, DepthIsBounded) {
    for (const int depth : {8000, 300}) {
        std::string deep = kVrml97, old = "#VRML V1.0 ascii\n", values = kVrml97 + "A { a ";
        for (int i = 0; i < depth; ++i) {
            deep += "Transform { children [\n";
            old += "Separator {\n";
            values += "B { b ";
        }
        EXPECT_TRUE(has(refusal_of(deep), "test.wrl:258: nodes are nested over 256 deep")) << refusal_of(deep);
        EXPECT_TRUE(has(refusal_of(old), "nested over 256 deep"));
        EXPECT_TRUE(has(refusal_of(values), "nested over 256 deep"));
        std::string protos = kVrml97;
        for (int i = 0; i < depth; ++i) protos += "PROTO P [ ] { ";
        EXPECT_TRUE(has(refusal_of(protos), "nested over 256 deep"));
    }
    // Not in the file, but made by USE and by PROTO.
    std::string used = kVrml97 + "Switch { choice [ DEF a0 Group { children Shape { geometry Box { } } }\n",
                made = kVrml97 + "PROTO P0 [ ] { Shape { geometry Box { } } }\n", groups = made;
    for (int i = 1; i < 1000; ++i) {
        const std::string last = std::to_string(i - 1), next = std::to_string(i);
        used += "DEF a" + next + " Group { children USE a" + last + " }\n";
        made += "PROTO P" + next + " [ ] { P" + last + " { } }\n";
        groups += "PROTO P" + next + " [ ] { Group { children P" + last + " { } } }\n";
    }
    EXPECT_TRUE(has(refusal_of(used + "] } USE a999"), "groups are nested over 256 deep"));
    EXPECT_TRUE(has(refusal_of(made + "P999 { }"), "made of each other over 256 deep"));
    EXPECT_TRUE(has(refusal_of(groups + "P999 { }"), "256 deep"));
}

// "A billion laughs": ten uses of ten uses of ...
TEST(VrmlHostile, UsesAreCounted) {
    for (const bool empty : {true, false}) {
        std::string laughs = kVrml97 + "DEF a0 Group { " + (empty ? "" : "children Shape { geometry Box { } }") + " }\n";
        for (int i = 1; i < 12; ++i) {
            laughs += "DEF a" + std::to_string(i) + " Group { children [ ";
            for (int k = 0; k < 10; ++k) laughs += "USE a" + std::to_string(i - 1) + " ";
            laughs += "] }\n";
        }
        EXPECT_TRUE(has(refusal_of(laughs), empty ? "grows beyond all bounds" : "the model has over 10000 parts"))
            << refusal_of(laughs);
    }
}

TEST(VrmlHostile, SizesThatAreOnlyClaimedCostNothing) {
    const std::string many = "[ 0 0 0 1 0 0 2 0 1 3 0 0 4 0 1 5 0 0 ]";
    for (const std::string& geometry : {
             std::string("ElevationGrid { xDimension 2000000000 zDimension 2000000000 height [ 1 ] }"),
             std::string("ElevationGrid { xDimension -5 zDimension 1e300 height [ 1 ] }"),
             "TriangleStripSet { coord Coordinate { point " + many + " } stripCount [ 1e300 1e300 -4 ] }",
             "TriangleFanSet { coord Coordinate { point " + many + " } fanCount [ 2000000000 ] }",
             std::string("IndexedFaceSet { coord Coordinate { point [ 0 0 0 ] } coordIndex [ 1e300 -1e300 4294967296 0 0 0 ] }"),
         }) {
        const std::string why = refusal_of("#X3D V3.3 utf8\nShape { geometry " + geometry + " }");
        EXPECT_TRUE(why.empty() || has(why, "test.wrl")) << why;
    }
    EXPECT_TRUE(has(refusal_of("#Inventor V2.1 ascii\nSeparator { Coordinate3 { point " + many +
                               " }\nFaceSet { startIndex -1e300 numVertices 1e300 } }"),
                    "test.wrl:3: startIndex"));
    std::string long_way;
    for (int i = 0; i < 3000; ++i) long_way += "0 " + std::to_string(i) + " 0 ";
    EXPECT_TRUE(
        has(refusal_of(kVrml97 + "Shape { geometry Extrusion { spine [ " + long_way + " ] crossSection [ " + long_way + " ] } }"),
            "Extrusion has over"));
}

TEST(VrmlHostile, PackedFilesAreUnpackedWithinALimit) {
    const std::string gz = packed(kAll);
    EXPECT_EQ(names_of(read_world(gz).model), names_of(read_world(kAll).model));
    EXPECT_EQ(vrml_format(std::string_view(gz).substr(0, 300)), "VRML97 model");
    EXPECT_EQ(vrml_format(packed("hello")), "");
    EXPECT_EQ(vrml_format(gz.substr(0, 5)), "");
    EXPECT_EQ(names_of(read_world(packed(kAllXml)).model), names_of(read_world(kAllXml).model));
    const std::string bomb = packed(kVrml97 + std::string(20u << 20, ' '));
    EXPECT_LT(bomb.size(), 1u << 17);
    EXPECT_EQ(gunzip(bomb, 1u << 20, "x").size(), 1u << 20);
    EXPECT_EQ(gunzip(bomb, 10, "x"), "#VRML V2.0");
    std::string broken = gz;
    broken[broken.size() - 6] ^= 1;  // of the checksum
    EXPECT_TRUE(has(refusal_of(broken), "cut short or damaged"));
}

TEST(VrmlHostile, TwoMillionTrianglesAreRead) {
    std::string text = kVrml97 + "Shape { geometry IndexedFaceSet { coord Coordinate { point [ ";
    constexpr int kSide = 1001;
    for (int i = 0; i < kSide * kSide; ++i) text += std::to_string(i % kSide) + ' ' + std::to_string(i / kSide) + " 0\n";
    text += "] } coordIndex [ ";
    for (int j = 0; j + 1 < kSide; ++j)
        for (int i = 0; i + 1 < kSide; ++i) {
            const std::string a = std::to_string(j * kSide + i), b = std::to_string(j * kSide + i + 1),
                              c = std::to_string((j + 1) * kSide + i + 1), d = std::to_string((j + 1) * kSide + i);
            text += a + ' ' + b + ' ' + c + " -1 " + a + ' ' + c + ' ' + d + " -1\n";
        }
    const ReadWorld world = read_world(text + "] } }");
    EXPECT_EQ(world.model.faces.size(), 2'000'000u);
    EXPECT_NEAR(area_of(world.model), 1e6 * 1e6, 1);
}

TEST(VrmlHostile, KindsOfFilesAreKnownByTheirBeginnings) {
    const std::pair<std::string, std::string_view> known[] = {
        {kAll, "VRML97 model"},
        {kAllOld, "VRML 1.0 model"},
        {kAllXml, "X3D model"},
        {"\xef\xbb\xbf" + kAll, "VRML97 model"},
        {"\n \n" + kAllOld, "VRML 1.0 model"},
        {"#X3D V3.0 utf8\nShape { }", "X3D model"},
        {"#Inventor V2.1 ascii\nCube { }", "Inventor model"},
        {packed(kAll), "VRML97 model"},
        {"<?xml version='1.0'?><COLLADA version='1.4.1'/>", "COLLADA model"},
    };
    for (const auto& [bytes, format] : known) {
        Source source = memory_source({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, "photo.jpg");
        EXPECT_EQ(model_format(source), format);
        EXPECT_EQ(look_at(source), Holds::model) << format;
        EXPECT_TRUE(has_unit(format));
    }
    EXPECT_EQ(names_of(read_world("\xef\xbb\xbf\n" + kAllOld).model), names_of(read_world(kAllOld).model));
    for (const std::string other :
         {"# a comment\n1 2\n3 4\n", "#Inventor V2.1 binary\n", "<svg xmlns='http://www.w3.org/2000/svg'/>", "#VRML"}) {
        Source source = memory_source({reinterpret_cast<const unsigned char*>(other.data()), other.size()}, "x");
        EXPECT_EQ(model_format(source), "") << other;
    }
    EXPECT_FALSE(has_unit("STL model"));
    // With a mark of its order, UTF-16 as XML may be.
    std::string wide = "\xff\xfe";
    for (const char c : kAllXml.substr(kAllXml.find("<X3D"))) wide += std::string{c, '\0'};
    Source source = memory_source({reinterpret_cast<const unsigned char*>(wide.data()), wide.size()}, "x");
    EXPECT_EQ(model_format(source), "X3D model");
    std::vector<Phrase> notes;
    EXPECT_EQ(names_of(read_model(source, notes)), names_of(read_world(kAllXml).model));
}

// The triangles of a model are its faces, cut.
TEST(VrmlHostile, AModelIsAlsoAMesh) {
    Source source = memory_source({reinterpret_cast<const unsigned char*>(kAll.data()), kAll.size()}, "x.wrl");
    std::vector<Phrase> notes;
    const Mesh mesh = read_mesh(source, notes);
    const Model model = read_world(kAll).model;
    double volume = 0;
    for (const auto& [a, b, c] : mesh.triangles) volume += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
    EXPECT_NEAR(volume / volume_of(model), 1, 0.01) << "bent faces may be cut either way";
    std::size_t triangles = 0;
    for (const ModelFace& face : model.faces) triangles += face.count - 2;
    EXPECT_EQ(mesh.triangles.size(), triangles);
}

}  // namespace
}  // namespace tactics::hostile_test
