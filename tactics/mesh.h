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

// What a mesh may have, whoever made it.
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

/// As it stands in the world: x to the right, y away from the reader, z upwards, all in mm and finite. What else its maker left
/// open is so here, too: vertices may lie in the same place, and triangles may have no area, be there twice and face either way.
struct Mesh {
    std::vector<Point3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< places in `vertices`, counter-clockwise seen from outside
    std::vector<MeshPart> parts;                          ///< one after another; none, or all triangles
};

}  // namespace tactics
