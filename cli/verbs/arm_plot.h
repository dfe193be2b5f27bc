// SPDX-License-Identifier: Apache-2.0
// A plot on an arm: its wall, axes, grid, curves, points and surface.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/verbs/arm_scene.h"
#include "tactics/haptics/simulated/arm.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Uses --plane, --feel, --fixture, --stiffness and --damping; `told` receives the parts left out. Throws Error.
ArmScene plot_on_arm(Plot plot, const Given& given, const ArmFile& file, std::vector<Phrase>& told);

}  // namespace tactics
