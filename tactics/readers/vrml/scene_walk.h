// SPDX-License-Identifier: Apache-2.0
// VRML97 and X3D: a scene of groups and shapes.
#pragma once

#include "tactics/readers/vrml/model_maker.h"
#include "tactics/readers/vrml/world.h"

namespace tactics {

/// Takes the finest level of LOD and the chosen child of Switch; ignores everything that moves, shines, sounds or is in another
/// file.
void walk_scene(const World& world, ModelMaker& maker);

}  // namespace tactics
