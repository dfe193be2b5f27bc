// SPDX-License-Identifier: Apache-2.0
// A model with no more faces than a page can show.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tactics/model.h"
#include "tactics/text/phrase.h"

namespace tactics {

inline constexpr std::size_t kMostWorkedCorners = 600'000;  ///< of faces; three times as many as triangles

/// Number of corners of the faces of its objects.
std::size_t corners_of(const Model& model);

/// The same objects with so few corners, if that can be: vertices in one cell of a grid become one (J. Rossignac and P. Borrel,
/// "Multi-resolution 3D approximations for rendering complex scenes", 1993), where the planes of their faces are least far, so
/// that sides stay plane and edges sharp (P. Lindstrom, "Out-of-core simplification of large polygonal models", SIGGRAPH 2000).
/// Faces that then have no area are left out. Cells are 1/512 of the model's longest side, which is half a millimetre of a
/// drawing as large as A4, or so much larger as it takes, up to 1/32. `notes` is told. Throws Error(failed): it has too many even
/// so.
Model coarse(const Model& model, std::vector<Phrase>& notes);

}  // namespace tactics
