// SPDX-License-Identifier: Apache-2.0
// A height map on an arm, felt from all directions above it.
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

/// Files that are drawn first use the whole plane in the workspace, upright unless --plane is given. Throws Error(usage).
void take_arm_as_paper(Wishes& drawing, const Given& given, const ArmFile& file);

/// Uses --plane, --stiffness and --damping; the lowest place lies on the plane. A map that would not fit is scaled down, with a
/// note. Without --plane, drawings are upright, like a page on a wall, and height maps flat, or upright if that makes them
/// larger. `radius`: of the fingertip, mm. Throws Error.
ArmScene relief_on_arm(FeltHeights felt, double radius, const Given& given, const ArmFile& file, std::vector<Phrase>& told);

}  // namespace tactics
