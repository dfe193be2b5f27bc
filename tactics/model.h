// SPDX-License-Identifier: Apache-2.0
// A model of things in space, as its file describes them: named objects in a hierarchy, made of plane faces.
//
// A Mesh (tactics/mesh.h) is what a fingertip touches; a Model still knows that this is a drawer, that it belongs to a desk, and
// that the lamp on the desk is a cylinder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tactics/point3.h"
#include "tactics/text/plain_name.h"

namespace tactics {

// Limits of a model, from any source.
inline constexpr std::size_t kMostModelCorners = 15'000'000;
inline constexpr std::size_t kMostModelObjects = 10'000;
inline constexpr std::size_t kMostModelName = 200;  ///< bytes of a name

/// The primitive that an object was made as; it has faces in any case.
enum class Primitive : std::uint8_t { none, box, cylinder, cone, sphere };

/// The frame of a primitive, in the world: its middle, and from there half of each of its three edges; for round ones, the radii
/// (a, b) and half the height (c, from the bottom to the top or the tip). Oblique and squeezed primitives keep their shape.
struct PrimitiveFrame {
    Point3 middle, a, b, c;
};

/// A plane polygon without holes: corners one after another in Model::corners, counter-clockwise seen from outside. A face from a
/// file may still be bent, cross itself, or have no area.
struct ModelFace {
    std::uint32_t first = 0;  ///< place in Model::corners
    std::uint32_t count = 0;  ///< at least 3
};

struct ModelObject {
    std::string name;  ///< UTF-8, one line; empty: the file gives none
    int line = 0;      ///< line in the file, for messages; 0: the file has no lines
    int parent = -1;   ///< index in Model::objects, always before its own; -1: it has no parent
    Primitive primitive = Primitive::none;
    PrimitiveFrame frame = {};           ///< of a primitive
    bool one_sided = true;               ///< its faces are visible from outside only; false: a sheet, or a file that does not say
    std::uint32_t first = 0, count = 0;  ///< its own faces in Model::faces, without those of its children
};

/// In world coordinates: x to the right, y away from the reader, z upwards, all in mm and finite.
struct Model {
    std::string title;                   ///< the file's name for the whole model; UTF-8, one line; may be empty
    UpAxis up = UpAxis::z;               ///< the axis of its file that points upwards
    Point3 viewed_from = {};             ///< the direction to the file's first viewpoint, of length 1; zero: it has none
    std::vector<Point3> vertices;        ///< several may coincide
    std::vector<std::uint32_t> corners;  ///< places in `vertices`
    std::vector<ModelFace> faces;
    std::vector<ModelObject> objects;
};

/// The object itself or its nearest ancestor that has a name; -1: none has.
inline int named_around(const Model& model, int object) {
    while (object >= 0 && model.objects[static_cast<std::size_t>(object)].name.empty())
        object = model.objects[static_cast<std::size_t>(object)].parent;
    return object;
}

/// Its plain name: the name of the thing whose shape it is, else its own, else that of its nearest named ancestor; as words,
/// without exporters' marks. Empty: none has a name.
inline std::string spoken_name(const Model& model, std::size_t object) {
    const auto name_of = [&](int at) -> const std::string& { return model.objects[static_cast<std::size_t>(at)].name; };
    int thing = named_around(model, static_cast<int>(object));
    if (thing < 0) return "";
    for (int outer = thing; outer >= 0;) {
        outer = named_around(model, model.objects[static_cast<std::size_t>(outer)].parent);
        if (outer < 0 || !names_shape_of(name_of(thing), name_of(outer))) break;
        thing = outer;
    }
    const std::string plain = plain_name(name_of(thing));
    const std::string words = name_as_words(plain);
    return words.empty() ? plain : words;
}

}  // namespace tactics
