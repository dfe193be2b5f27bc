// SPDX-License-Identifier: Apache-2.0
// Worlds read from text, and what can be measured on them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/error.h"
#include "tactics/readers/vrml/vrml.h"

namespace tactics::tests {

inline const std::string kVrml97 = "#VRML V2.0 utf8\n";

struct ReadWorld {
    Model model;
    std::vector<Phrase> notes;
};
inline ReadWorld read_world(std::string_view text, const std::string& name = "test.wrl") {
    Source source = memory_source({reinterpret_cast<const unsigned char*>(text.data()), text.size()}, name);
    ReadWorld world;
    world.model = read_vrml(source, world.notes);
    return world;
}
inline std::string refusal_of(std::string_view text, const std::string& name = "test.wrl") {
    try {
        read_world(text, name);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

inline std::vector<Point3> ring_of(const Model& model, const ModelFace& face) {
    std::vector<Point3> ring;
    for (std::uint32_t k = 0; k < face.count; ++k) ring.push_back(model.vertices[model.corners[face.first + k]]);
    return ring;
}
/// Its direction is that out of the face, its length the area.
inline Point3 area_vector(const std::vector<Point3>& ring) {
    Point3 twice;
    for (std::size_t i = 2; i < ring.size(); ++i) twice = twice + cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
    return 0.5 * twice;
}
/// By the theorem of Gauss: over 0 if all faces of a closed thing look outwards.
inline double volume_of(const Model& model) {
    double six = 0;
    for (const ModelFace& face : model.faces) {
        const auto ring = ring_of(model, face);
        for (std::size_t i = 2; i < ring.size(); ++i) six += dot(ring[0], cross(ring[i - 1], ring[i]));
    }
    return six / 6;
}
inline double area_of(const Model& model) {
    double area = 0;
    for (const ModelFace& face : model.faces) area += length_of(area_vector(ring_of(model, face)));
    return area;
}
/// The area vectors of what is closed have no sum.
inline double openness_of(const Model& model) {
    Point3 sum;
    for (const ModelFace& face : model.faces) sum = sum + area_vector(ring_of(model, face));
    return length_of(sum);
}

struct Bounds {
    Point3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    Point3 size() const { return high - low; }
    Point3 middle() const { return 0.5 * (low + high); }
};
inline Bounds bounds_of(const Model& model, const ModelObject& object) {
    Bounds box;
    for (std::uint32_t i = object.first; i < object.first + object.count; ++i)
        for (const Point3& at : ring_of(model, model.faces[i])) {
            box.low = {std::min(box.low.x, at.x), std::min(box.low.y, at.y), std::min(box.low.z, at.z)};
            box.high = {std::max(box.high.x, at.x), std::max(box.high.y, at.y), std::max(box.high.z, at.z)};
        }
    return box;
}
inline void expect_near(const Point3& a, const Point3& b, double within) {
    EXPECT_NEAR(a.x, b.x, within);
    EXPECT_NEAR(a.y, b.y, within);
    EXPECT_NEAR(a.z, b.z, within);
}

/// What every Model promises.
inline void expect_sound(const Model& model) {
    for (const Point3& vertex : model.vertices) ASSERT_TRUE(is_finite(vertex));
    for (const std::uint32_t corner : model.corners) ASSERT_LT(corner, model.vertices.size());
    std::size_t of_objects = 0;
    for (const ModelFace& face : model.faces) {
        ASSERT_GE(face.count, 3u);
        ASSERT_LE(std::size_t{face.first} + face.count, model.corners.size());
    }
    for (std::size_t i = 0; i < model.objects.size(); ++i) {
        const ModelObject& object = model.objects[i];
        ASSERT_LT(object.parent, static_cast<int>(i));
        ASSERT_LE(std::size_t{object.first} + object.count, model.faces.size());
        ASSERT_LE(object.name.size(), kMostModelName);
        of_objects += object.count;
    }
    ASSERT_EQ(of_objects, model.faces.size());
    ASSERT_FALSE(model.faces.empty());
}

/// "Table(Top Leg(LegShape))", the hierarchy on one line.
inline std::string names_of(const Model& model, int parent = -1) {
    std::string text;
    for (std::size_t i = 0; i < model.objects.size(); ++i) {
        if (model.objects[i].parent != parent) continue;
        const std::string inside = names_of(model, static_cast<int>(i));
        text += (text.empty() ? "" : " ") + (model.objects[i].name.empty() ? "-" : model.objects[i].name) +
                (inside.empty() ? "" : "(" + inside + ")");
    }
    return text;
}

}  // namespace tactics::tests
