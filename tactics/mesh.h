// SPDX-License-Identifier: Apache-2.0
// A solid or a surface in space, made of triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tactics/point3.h"

namespace tactics {

// Limits of a mesh, from any source.
inline constexpr std::size_t kMostMeshTriangles = 5'000'000;
inline constexpr std::size_t kMostMeshVertices = 3 * kMostMeshTriangles;
inline constexpr std::size_t kMostMeshParts = 10'000;
inline constexpr std::size_t kMostMeshName = 200;  ///< bytes of a part's name

/// Triangles that belong together: an object of the file.
struct MeshPart {
    std::string name;         ///< UTF-8, one line; may be empty
    std::uint32_t first = 0;  ///< triangle
    std::uint32_t count = 0;
};

/// In world coordinates: x to the right, y away from the reader, z upwards, all in mm and finite. Nothing else is guaranteed:
/// vertices may coincide, and triangles may have no area, occur twice and face either way.
struct Mesh {
    std::vector<Point3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< places in `vertices`, counter-clockwise seen from outside
    std::vector<MeshPart> parts;                          ///< in order; either no parts, or parts that cover all triangles
    UpAxis up = UpAxis::z;                                ///< the axis of the file that points upwards
};

}  // namespace tactics
