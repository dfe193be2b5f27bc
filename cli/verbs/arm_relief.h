// SPDX-License-Identifier: Apache-2.0
// A height map on an arm: whatever play lifts a finger over, felt from all directions above it.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/verbs/arm_scene.h"
#include "tactics/haptics/simulated/arm.h"
#include "tactics/job/felt_heights.h"
#include "tactics/job/wishes.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// Whatever is drawn first is drawn for all of the plane that the workspace has, upright if no --plane is named. Throws
/// Error(usage).
void take_arm_as_paper(Wishes& drawing, const Given& given, const ArmFile& file);

/// By --plane, --stiffness and --damping; its lowest place on the plane, and smaller than it is where it would not fit, which is
/// told. Where no plane is named, what is drawn is upright, as a page on a wall, and heights are flat, or upright if they are
/// larger so. `radius`: of the fingertip, mm. Throws Error.
ArmScene relief_on_arm(FeltHeights felt, double radius, const Given& given, const ArmFile& file, std::vector<Phrase>& told);

}  // namespace tactics
