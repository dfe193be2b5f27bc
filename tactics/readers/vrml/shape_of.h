// SPDX-License-Identifier: Apache-2.0
// The geometry nodes of VRML97 and X3D.
#pragma once

#include <optional>

#include "tactics/readers/vrml/resolved.h"
#include "tactics/readers/vrml/shape.h"

namespace tactics {

/// Of a node that stands as the geometry of a Shape. Nothing: it has no faces, as lines have none, or nobody knows it, which is
/// noted.
std::optional<WorldShape> shape_of(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker);

}  // namespace tactics
