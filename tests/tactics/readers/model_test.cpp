// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "tactics/error.h"
#include "tactics/job/holds.h"
#include "tactics/measure/random.h"
#include "tactics/readers/caged/protocol.h"
#include "tactics/transport/program_folder.h"

namespace tactics::model_test {
namespace {

constexpr std::string_view kObj =
    "# a roof\nmtllib colours.mtl\no left\nv 0 0 0\nv 10 0 0\nv 10 20 0\nv 0 20 5\nf 1 2 3\no right\nf 1 3 4\n";
constexpr std::string_view kPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n10 0 0\n10 20 0\n0 20 5\n4 0 1 2 3\n";

std::string base64(std::string_view bytes) {
    constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (int k = 3; k >= 0; --k) text += kLetters[group >> (6 * k) & 63];
    }
    return text;  // of whole groups, as all here are
}

// One triangle a metre wide, lifted by its node by 2 m.
std::string gltf(const std::string& uri) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
           R"("nodes":[{"name":"board","mesh":0,"translation":[0,2,0]}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
           R"("buffers":[{"byteLength":36,"uri":")" +
           uri +
           R"("}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,0,1]}]})";
}
std::string triangle_bytes() {
    const float corners[9] = {0, 0, 0, 0, 0, 1, 1, 0, 0};
    return {reinterpret_cast<const char*>(corners), sizeof corners};
}
std::string whole_gltf() { return gltf("data:application/octet-stream;base64," + base64(triangle_bytes())); }

Source source_of(std::string_view bytes, std::string name) {
    return memory_source({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, std::move(name));
}
Mesh read(std::string_view bytes, std::vector<Phrase>& notes, const std::string& name = "model") {
    Source source = source_of(bytes, name);
    return read_mesh(source, notes);
}

class Model : public ::testing::Test {
protected:
    void SetUp() override {
        if (own_program(caged::kAssimp.name).empty()) GTEST_SKIP() << "tactics-assimp was not built (libassimp-dev)";
    }
    std::vector<Phrase> notes;
};

TEST(ModelFormat, IsKnownByBytesAndNotByName) {
    const std::string text = whole_gltf();
    const std::pair<std::string_view, std::string_view> known[] = {
        {kObj, "OBJ model"}, {kPly, "PLY model"}, {text, "glTF model"}, {"glTF\2\0\0\0", "glTF model"}};
    for (const auto& [bytes, name] : known) {
        Source source = source_of(bytes, "photo.jpg");
        EXPECT_EQ(model_format(source), name);
        EXPECT_EQ(look_at(source), Holds::model);
    }
    for (const std::string_view other :
         {"x,y\n1,2\n", "{\"a\": [1, 2]}", "<svg/>", "v\n", "f one two\nv 1 2 3\nhello\n", "P2 1 1 1 0"}) {
        Source source = source_of(other, "x.csv");
        EXPECT_EQ(model_format(source), "") << other;
    }
}

TEST_F(Model, ObjHasItsPartsByName) {
    const Mesh mesh = read(kObj, notes);
    EXPECT_EQ(mesh.triangles.size(), 2u);
    ASSERT_EQ(mesh.parts.size(), 2u);
    EXPECT_EQ(mesh.parts[0].name, "left");
    EXPECT_EQ(mesh.parts[1].name, "right");
    EXPECT_EQ(mesh.parts[1].first, 1u);
    double tallest = 0;
    for (const Point3& vertex : mesh.vertices) tallest = std::max(tallest, vertex.z);
    EXPECT_EQ(tallest, 5);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].english().find("colours.mtl"), std::string::npos) << notes[0].english();
}

TEST_F(Model, PlyOfSquaresIsCutIntoTriangles) {
    const Mesh mesh = read(kPly, notes);
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_TRUE(notes.empty());
}

TEST_F(Model, GltfIsInMillimetresAndStandsUpright) {
    const Mesh mesh = read(whole_gltf(), notes);
    ASSERT_EQ(mesh.triangles.size(), 1u);
    ASSERT_EQ(mesh.parts.size(), 1u);
    EXPECT_EQ(mesh.parts[0].name, "board");
    for (const Point3& vertex : mesh.vertices) EXPECT_NEAR(vertex.z, 2000, 1e-3);
    const auto& corner = mesh.triangles[0];
    const Point3 &a = mesh.vertices[corner[0]], &b = mesh.vertices[corner[1]], &c = mesh.vertices[corner[2]];
    EXPECT_NEAR(cross(b - a, c - a).z, 1e6, 1);  // it faced up, and does
}

// Assimp's names and groups come across; a node's meshes of several materials are one part.
TEST_F(Model, ColladaKeepsItsHierarchyAndStandsUprightInMillimetres) {
    const std::string geometry = [](const std::string& id) {
        return "<geometry id='" + id + "'><mesh><source id='" + id + "p'><float_array id='" + id +
               "a' count='9'>0 0 0 10 0 0 10 0 20</float_array><technique_common><accessor source='#" + id +
               "a' count='3' stride='3'><param name='X' type='float'/><param name='Y' type='float'/><param name='Z' "
               "type='float'/>"
               "</accessor></technique_common></source><vertices id='" +
               id + "v'><input semantic='POSITION' source='#" + id +
               "p'/></vertices><triangles count='1'><input semantic='VERTEX' source='#" + id +
               "v' offset='0'/><p>0 1 2</p></triangles></mesh></geometry>";
    }("g");
    const std::string text =
        "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset>"
        "<unit name='inch' meter='0.0254'/><up_axis>Z_UP</up_axis></asset><library_geometries>" +
        geometry +
        "</library_geometries><library_visual_scenes><visual_scene id='s' name='kitchen'><node id='ID1' name='Tisch'>"
        "<node id='ID2' name='Platte'><translate>0 0 29</translate><instance_geometry url='#g'/></node>"
        "<node id='ID3' name='Bein'><instance_geometry url='#g'/></node></node><node id='ID4' name='nothing'/>"
        "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene></COLLADA>";
    Source source = source_of(text, "x");
    ASSERT_EQ(model_format(source), "COLLADA model");
    const tactics::Model model = read_model(source, notes);
    ASSERT_EQ(model.objects.size(), 3u);
    EXPECT_EQ(model.objects[0].name, "Tisch");
    EXPECT_EQ(model.objects[0].parent, -1);
    EXPECT_EQ(model.objects[0].count, 0u);
    EXPECT_EQ(model.objects[1].name, "Platte");
    EXPECT_EQ(model.objects[1].parent, 0);
    EXPECT_EQ(model.objects[1].count, 1u);
    EXPECT_EQ(model.objects[2].name, "Bein");
    EXPECT_EQ(model.objects[2].parent, 0);
    const Point3& high = model.vertices[model.corners[model.faces[0].first + 2]];
    EXPECT_NEAR(high.x, 254, 1e-2);
    EXPECT_NEAR(high.z, (29 + 20) * 25.4, 1e-2);
    const Mesh mesh = read(text, notes);
    ASSERT_EQ(mesh.parts.size(), 2u) << "groups are no parts of a mesh";
    EXPECT_EQ(mesh.parts[1].name, "Bein");
}

TEST_F(Model, ANameInObjMayHaveBlanks) {
    const Mesh mesh =
        read("o Pot 1\nv 0 0 0\nv 10 0 0\nv 10 20 0\nv 0 20 5\nf 1 2 3\no  Pot \t 2 of two \r\nf 1 3 4\no other\nf 1 2 4\n",
             notes, "pots.obj");
    ASSERT_EQ(mesh.parts.size(), 3u);
    EXPECT_EQ(mesh.parts[0].name, "Pot 1");
    EXPECT_EQ(mesh.parts[1].name, "Pot 2 of two");
    EXPECT_EQ(mesh.parts[2].name, "other");
}

TEST_F(Model, OpensNoOtherFile) {
    for (const std::string& uri : {std::string("/etc/passwd"), std::string("beside.bin"), std::string("http://127.0.0.1/x.bin")})
        EXPECT_THROW(read(gltf(uri), notes), Error) << uri;
}

TEST_F(Model, WhatIsNoNumberOrCutShortIsRefusedAndTheNextIsRead) {
    for (const std::string_view bad : {"v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", "v 0 0 0\nf 1 2 3\n", "v 1 2 3\nv 1 2 4\n"}) {
        try {
            read(bad, notes, "bad.obj");
            ADD_FAILURE() << bad;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("bad.obj"), std::string::npos);
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
        EXPECT_EQ(read(kPly, notes).triangles.size(), 2u);
    }
}

TEST_F(Model, DamagedFilesCostThemselvesOnly) {
    RandomNumbers random(12);
    const std::string text = whole_gltf();
    int read_well = 0;
    for (const std::string_view whole : {kObj, kPly, std::string_view(text)})
        for (int i = 0; i < 20; ++i) {
            std::string bytes(whole);
            if (i % 3 == 0)
                bytes.resize(random.below(bytes.size()));
            else
                for (int k = 0; k < 4; ++k) bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
            try {
                const Mesh mesh = read(bytes, notes, "damaged.obj");
                ++read_well;
                for (const Point3& vertex : mesh.vertices) ASSERT_TRUE(is_finite(vertex));
                for (const auto& triangle : mesh.triangles)
                    for (const std::uint32_t corner : triangle) ASSERT_LT(corner, mesh.vertices.size());
            } catch (const Error&) {
            }
        }
    EXPECT_GT(read_well, 0);
    EXPECT_EQ(read(kPly, notes).triangles.size(), 2u);
}

// Counts that no file could hold, a list longer than the file, a number of corners that is none.
TEST_F(Model, PlyThatPromisesMoreThanItHasIsRefused) {
    const auto changed = [](std::string_view from, std::string_view to) {
        std::string bytes(kPly);
        return bytes.replace(bytes.find(from), from.size(), to);
    };
    for (const std::string& bad :
         {changed("face 1", "face 4000000000"), changed("vertex 4", "vertex 4000000000"), changed("4 0 1 2 3", "4 0 1 2 3000000"),
          changed("4 0 1 2 3", "4 0 1 2 -1"), changed("ascii", "binary_little_endian"),
          changed("property float z", "property flaot z"), changed("end_header", "end_haeder")})
        EXPECT_THROW(read(bad, notes), Error) << bad;
    EXPECT_EQ(read(kPly, notes).triangles.size(), 2u);
}

// Each of these is a glTF by its grammar, and none of them makes sense.
TEST_F(Model, HostileGltfIsRefused) {
    const auto changed = [](std::string_view from, std::string_view to) {
        std::string bytes = whole_gltf();
        return bytes.replace(bytes.find(from), from.size(), to);
    };
    const std::string cases[] = {
        changed(R"("count":3)", R"("count":4000000000)"),                 // an accessor longer than its buffer
        changed(R"("count":3)", R"("count":3,"byteOffset":4294967290)"),  // its end overflows
        changed(R"("buffer":0,"byteLength":36)", R"("buffer":0,"byteOffset":30,"byteLength":36)"),  // a view beyond its buffer
        changed(R"("buffer":0,)", R"("buffer":7,)"),                                                // a buffer that is not there
        changed(R"("mesh":0,)", R"("mesh":0,"children":[0],)"),  // a node that is its own child
        changed(R"("POSITION":0)", R"("POSITION":99)"),          // an accessor that is not there
    };
    for (const std::string& bad : cases) EXPECT_THROW(read(bad, notes), Error) << bad;
    EXPECT_EQ(read(kPly, notes).triangles.size(), 2u);
}

TEST_F(Model, OneTriangleTooManyIsTold) {
    std::string ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 5000001\nproperty list uchar uchar vertex_indices\nend_header\n";
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    ply.append(reinterpret_cast<const char*>(corners), sizeof corners);
    constexpr char kFace[] = {3, 0, 1, 2};
    for (int i = 0; i < 5'000'001; ++i) ply.append(kFace, sizeof kFace);
    try {
        read(ply, notes, "many.ply");
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("5000000 triangles"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace tactics::model_test
