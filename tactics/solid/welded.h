// SPDX-License-Identifier: Apache-2.0
// Polygons as files have them, made into a surface that hangs together: corners
// in one place are one corner, a corner on the side of a neighbour is a corner
// of that neighbour, and all faces are seen from the same side.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tactics/model.h"

namespace tactics {

/// A polygon by its corners, counter-clockwise seen from outside.
using CornerRing = std::vector<std::uint32_t>;

struct WeldedSurface {
    std::vector<Point3> corners;
    std::vector<CornerRing> faces;
    double tolerance = 0;  ///< mm: corners nearer than that were one
};

/// Some faces of a model. What has no area or is there twice is left out and
/// counted in `dropped`. A face that is bent is cut into triangles. Takes time
/// in proportion to the corners, but for sorting.
WeldedSurface weld(const Model& model, const std::vector<std::uint32_t>& faces, double tolerance, std::size_t& dropped);

/// One side of a face, the way that the face goes round.
struct FaceSide {
    std::uint32_t from, to, face;
};

/// The triangles that stand for a polygon of which a corner is off its plane by more than that, as places in it; the same
/// wherever the polygon begins. None for one that is plane.
std::vector<std::array<std::uint32_t, 3>> cut_if_bent(std::vector<Point3> ring, double tolerance);

/// Shells: faces that hang together by sides, as places in `surface.faces`; in
/// the order of their first faces.
std::vector<std::vector<std::uint32_t>> shells_of(const WeldedSurface& surface);

/// Turns faces that neighbours see from the other side, and a closed shell that
/// is inside out.
void face_outwards(WeldedSurface& surface, const std::vector<std::uint32_t>& shell);

/// Twice the area, pointing outwards (M. E. Newell's sum; holds for polygons
/// that are bent or not convex).
Point3 doubled_area(const std::vector<Point3>& corners, const CornerRing& ring);

}  // namespace tactics
