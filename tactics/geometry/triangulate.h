// SPDX-License-Identifier: Apache-2.0
// Plane polygons as triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/mesh.h"
#include "tactics/model.h"

namespace tactics {

/// Twice the area of a polygon, pointing outwards; it may be bent, and need not be convex (M. E. Newell). `at`: its corners.
template <typename At>
Point3 doubled_area(std::size_t corners, At at) {
    Point3 sum;
    for (std::size_t i = 2; i < corners; ++i) sum = sum + cross(at(i - 1) - at(0), at(i) - at(0));
    return sum;
}

/// Places in `ring`, which is counter-clockwise seen from outside, as the triangles are: two fewer than there are corners, which
/// together have its area and direction, whatever it is. They do not overlap if it lies in a plane and does not cross itself;
/// corners may be alike, as those of a cut to a hole are. Ears are cut off (G. Meisters, "Polygons have ears", 1975); after
/// some millions of looks, as only thousands of corners that go in and out need, the rest is a fan.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Point3> ring);

/// The mesh that a fingertip touches: each object with faces is a part, under its name or that of its nearest named ancestor.
/// Throws Error(failed) at `file` for over kMostMeshTriangles.
Mesh mesh_of(const Model& model, const std::string& file);

/// Every part is an object, every triangle a face. `one_sided`: it is known that they look outwards.
Model model_of(Mesh mesh, bool one_sided);

/// Signed area of a plane ring, positive if it turns from x to y.
double doubled_area(const std::vector<Point>& ring);

}  // namespace tactics
