// SPDX-License-Identifier: Apache-2.0
// The geometry of one node, in its own coordinates, before it is placed in the world.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "tactics/model.h"

namespace tactics {

/// Round things become this many flat sides: their outline is nowhere off by over 0.5 % of the radius (1 - cos(pi / 32)), and
/// their box is exact.
inline constexpr std::size_t kRoundSides = 32;

/// Places in a shape's lists, which models keep in 32 bits.
constexpr std::uint32_t index32(std::size_t at) { return static_cast<std::uint32_t>(at); }

struct WorldShape {
    std::vector<Point3> vertices;
    std::vector<std::uint32_t> corners;
    std::vector<ModelFace> faces;
    Primitive primitive = Primitive::none;
    PrimitiveFrame frame = {};
    bool one_sided = true;
    std::size_t bad_faces = 0;  ///< left out: a corner that is not there, fewer than three, no area at all

    void add_face(std::span<const std::uint32_t> places);
    void add_face(std::initializer_list<std::uint32_t> places) { add_face(std::span(places.begin(), places.size())); }
    void turn_inside_out();
};

// All stand in their middle with their axis upwards (y), as VRML's do.
WorldShape make_box(const Point3& size);  ///< one length may be 0: then it is a sheet and no primitive
WorldShape make_sphere(double radius);
struct RoundParts {
    bool side = true, bottom = true, top = true;
};
WorldShape make_cylinder(double radius, double height, RoundParts parts);
WorldShape make_cone(double radius, double height, RoundParts parts);

/// How places tell which of them make a face.
enum class FaceRuns : std::uint8_t { polygons, triangles, strips, fans, quads };
/// The same faces as runs that -1 ends. Negative places end a strip or a fan. Not of polygons, which are so already.
std::vector<double> faces_in(std::span<const double> places, FaceRuns runs);

/// Runs of places that a negative one ends, as coordIndex has them, of `points`, three numbers each.
WorldShape make_faces(std::span<const double> points, std::span<const double> indices);

struct ElevationFields {
    std::size_t across = 0, along = 0;  ///< xDimension, zDimension
    double across_step = 1, along_step = 1;
    std::span<const double> heights;  ///< across * along
};
WorldShape make_elevation(const ElevationFields& fields);

struct ExtrusionFields {
    std::span<const double> section{};       ///< two numbers each
    std::span<const double> spine{};         ///< three
    std::span<const double> scales{};        ///< two
    std::span<const double> orientations{};  ///< four: axis, angle in radians
    bool begin_cap = true, end_cap = true;
};
/// ISO/IEC 14772-1, 6.18
WorldShape make_extrusion(const ExtrusionFields& fields);

}  // namespace tactics
