// SPDX-License-Identifier: Apache-2.0
// Polygons as files have them, made into a surface that hangs together: corners
// in one place are one corner, a corner on the side of a neighbour is a corner
// of that neighbour, and all faces are seen from the same side.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tactics/model.h"
#include "tactics/solid/welded_surface.h"

namespace tactics {

/// Some faces of a model. What has no area or is there twice, also for both sides of a sheet, is left out and counted in
/// `dropped`. A face that is bent is cut into triangles. Takes time in proportion to the corners, but for sorting.
WeldedSurface weld(const Model& model, const std::vector<std::uint32_t>& faces, double tolerance, std::size_t& dropped);

/// The triangles that stand for a polygon of which a corner is off its plane by more than that, as places in it; the same
/// wherever the polygon begins. One of four corners is cut along its shorter diagonal. None for one that is plane.
std::vector<std::array<std::uint32_t, 3>> cut_if_bent(std::vector<Point3> ring, double tolerance);

/// Shells: faces that hang together by sides, as places in `surface.faces`; in
/// the order of their first faces.
std::vector<std::vector<std::uint32_t>> shells_of(const WeldedSurface& surface);

/// Turns faces that neighbours see from the other side, and a closed shell that
/// is inside out.
void face_outwards(WeldedSurface& surface, const std::vector<std::uint32_t>& shell);

}  // namespace tactics
