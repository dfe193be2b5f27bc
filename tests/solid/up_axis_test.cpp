// SPDX-License-Identifier: Apache-2.0
// A model stands the same way whichever axis of its file points upwards, if the file or the user says so.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "tactics/geometry/triangulate.h"
#include "tactics/readers/model.h"
#include "tactics/relief/height_picture.h"
#include "tactics/solid/fold_out.h"
#include "tests/solid/models.h"

namespace tactics::up_axis_test {
namespace {

constexpr std::array kAxes{UpAxis::x, UpAxis::y, UpAxis::z};

// Its length, breadth and height differ.
Model stand() {
    Model model;
    tests::add_box(model, "Stand", -1, {0, 0, 10}, {120, 80, 20});
    return model;
}

// A place of a file whose reader looks along an axis, with another to the right and a third upwards: the table of COLLADA 1.4.1,
// written down apart from the product's.
Point3 in_file(const Point3& at, UpAxis up) {
    Point3 file;
    switch (up) {
        case UpAxis::x:  // right: negative y, up: positive x, towards the viewer: positive z
            file.y = -at.x;
            file.x = at.z;
            file.z = -at.y;
            break;
        case UpAxis::y:  // right: positive x, up: positive y, towards the viewer: positive z
            file.x = at.x;
            file.y = at.z;
            file.z = -at.y;
            break;
        case UpAxis::z:  // right: positive x, up: positive z, towards the viewer: negative y
            file = at;
    }
    return file;
}

std::vector<Point3> triangles_in_file(UpAxis up) {
    std::vector<Point3> corners;
    const Mesh mesh = mesh_of(stand(), "stand");
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) corners.push_back(in_file(mesh.vertices[corner], up));
    return corners;
}

std::string numbers(const Point3& at) { return std::to_string(at.x) + " " + std::to_string(at.y) + " " + std::to_string(at.z); }

std::string obj(UpAxis up) {
    std::string text, faces;
    int count = 0;
    for (const Point3& at : triangles_in_file(up)) text += "v " + numbers(at) + "\n";
    for (std::size_t i = 0; i < triangles_in_file(up).size(); i += 3) {
        faces += "f";
        for (int k = 0; k < 3; ++k) faces += " " + std::to_string(++count);
        faces += "\n";
    }
    return text + faces;
}

std::string collada(UpAxis up, const std::string& said) {
    std::string places, corners;
    const auto all = triangles_in_file(up);
    for (std::size_t i = 0; i < all.size(); ++i) {
        places += numbers(all[i]) + " ";
        corners += std::to_string(i) + " ";
    }
    const std::string count = std::to_string(3 * all.size()), vertices = std::to_string(all.size());
    return "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset>"
           "<unit name='millimeter' meter='0.001'/>" +
           said + "</asset><library_geometries><geometry id='g'><mesh><source id='p'><float_array id='a' count='" + count + "'>" +
           places + "</float_array><technique_common><accessor source='#a' count='" + vertices +
           "' stride='3'><param name='X' type='float'/><param name='Y' type='float'/><param name='Z' type='float'/></accessor>"
           "</technique_common></source><vertices id='v'><input semantic='POSITION' source='#p'/></vertices><triangles count='" +
           std::to_string(all.size() / 3) + "'><input semantic='VERTEX' source='#v' offset='0'/><p>" + corners +
           "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id='s'><node id='n' "
           "name='Stand'><rotate>0 0 1 0</rotate><instance_geometry url='#g'/></node></visual_scene></library_visual_scenes>"
           "<scene><instance_visual_scene url='#s'/></scene></COLLADA>";
}

std::string collada(UpAxis up) {
    return collada(up, "<up_axis>" + std::string(1, "XYZ"[static_cast<int>(up)]) + "_UP</up_axis>");
}

Model read(const std::string& bytes, const std::string& name, std::optional<UpAxis> up) {
    Source source = memory_source({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, name);
    std::vector<Phrase> notes;
    return read_model(source, notes, up);
}

// Also that faces look outwards, as they do in order.
void expect_stand(const Model& model, const std::string& what) {
    const Mesh mesh = mesh_of(stand(), "stand");
    ASSERT_EQ(model.corners.size(), 3 * mesh.triangles.size()) << what;
    for (std::size_t i = 0; i < model.corners.size(); ++i)
        EXPECT_LT(length_of(model.vertices[model.corners[i]] - mesh.vertices[mesh.triangles[i / 3][i % 3]]), 1e-3) << what;
}

TEST(UpAxis, TurnsAndDoesNotMirror) {
    for (const UpAxis from : kAxes)
        for (const UpAxis to : kAxes) {
            const Point3 x = turned_up({1, 0, 0}, from, to), y = turned_up({0, 1, 0}, from, to),
                         z = turned_up({0, 0, 1}, from, to);
            EXPECT_EQ(cross(x, y), z);
            EXPECT_EQ(dot(x, x) * dot(y, y), 1);
            const Point3 at{3, 4, 5};
            EXPECT_EQ(turned_up(turned_up(at, from, to), to, from), at);
            EXPECT_EQ(turned_up(in_file(at, to), UpAxis::z, to), at) << "of a file that says nothing";
        }
}

TEST(UpAxis, OfAFileThatDoesNotSayIsTheUsersWord) {
    for (const UpAxis up : kAxes) expect_stand(read(obj(up), "stand.obj", up), "OBJ, " + std::string(name_of(up)));
    EXPECT_EQ(read(obj(UpAxis::z), "stand.obj", {}).up, UpAxis::z);
}

TEST(UpAxis, IsTheOneThatColladaSays) {
    for (const UpAxis up : kAxes) {
        const Model model = read(collada(up), "stand.dae", {});
        EXPECT_EQ(model.up, up);
        expect_stand(model, "COLLADA, " + std::string(name_of(up)));
        expect_stand(read(collada(up), "stand.dae", up), "COLLADA, told the same");
    }
    EXPECT_EQ(read(collada(UpAxis::y, ""), "stand.dae", {}).up, UpAxis::y) << "the default of COLLADA 1.4.1";
}

TEST(UpAxis, OfAFileThatIsWrongIsTheUsersWord) {
    for (const UpAxis up : kAxes)
        for (const UpAxis said : kAxes) {
            const std::string word = std::string(1, "XYZ"[static_cast<int>(said)]);
            const Model model = read(collada(up, "<up_axis>" + word + "_UP</up_axis>"), "stand.dae", up);
            EXPECT_EQ(model.up, up);
            expect_stand(model, word + "_UP and in truth " + std::string(name_of(up)));
        }
}

TEST(UpAxis, HeightsGoAlongIt) {
    const auto heights = [](UpAxis of_file, std::optional<UpAxis> said) {
        const std::string bytes = obj(of_file);
        Source source = memory_source({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, "stand.obj");
        return model_for_picture(source, said).map;
    };
    const HeightMap map = heights(UpAxis::z, {});
    ASSERT_FALSE(map.heights.empty());
    for (const UpAxis up : kAxes) {
        const HeightMap other = heights(up, up);
        ASSERT_EQ(other.heights.size(), map.heights.size()) << name_of(up);
        for (std::size_t i = 0; i < map.heights.size(); ++i) ASSERT_NEAR(other.heights[i], map.heights[i], 1e-3) << name_of(up);
    }
}

TEST(UpAxis, IsToldOfTheDrawing) {
    std::vector<Phrase> notes;
    const FoldOut made =
        fold_out(read(obj(UpAxis::y), "stand.obj", UpAxis::y), 150, 200, find_medium("swell", "test"), {}, notes);
    EXPECT_EQ(made.up, UpAxis::y);
}

}  // namespace
}  // namespace tactics::up_axis_test
