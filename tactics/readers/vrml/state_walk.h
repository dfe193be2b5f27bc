// SPDX-License-Identifier: Apache-2.0
// VRML 1.0 and Open Inventor: a sequence of nodes, each of which changes the state for the following ones.
#pragma once

#include "tactics/readers/vrml/model_maker.h"
#include "tactics/readers/vrml/world.h"

namespace tactics {

/// As `walk_scene`, of the dialect vrml1.
void walk_states(const World& world, ModelMaker& maker);

}  // namespace tactics
