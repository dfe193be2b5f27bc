// SPDX-License-Identifier: Apache-2.0
// The geometry nodes of VRML97 and X3D.
#pragma once

#include <optional>

#include "tactics/readers/vrml/resolved.h"
#include "tactics/readers/vrml/shape.h"

namespace tactics {

/// The shape of a node used as the geometry of a Shape. Nothing: it has no faces, like lines, or is unknown; a note says so.
std::optional<WorldShape> shape_of(ResolvedWorld& world, const WorldPlace& at, ModelMaker& maker);

}  // namespace tactics
