// SPDX-License-Identifier: Apache-2.0
// A model on an arm: a solid in the middle of the workspace, felt from all sides.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/verbs/arm_scene.h"
#include "tactics/haptics/simulated/arm.h"
#include "tactics/mesh.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Uses --plane (on which it stands; default: a table), --width, --radius, --stiffness and --damping. It is as large as the
/// workspace holds, or has the requested width if that is less; a note gives its size. Throws Error.
ArmScene model_on_arm(const Mesh& mesh, const std::string& name, const Given& given, const ArmFile& file,
                      std::vector<Phrase>& told);

}  // namespace tactics
