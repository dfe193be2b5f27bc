// SPDX-License-Identifier: Apache-2.0
// The options of a play on an arm. Each function throws Error(usage) if its option is invalid.
#pragma once

#include <optional>
#include <vector>

#include "cli/command.h"
#include "tactics/haptics/devices/mounting.h"
#include "tactics/haptics/scenes/fixture.h"
#include "tactics/haptics/scenes/force_law.h"
#include "tactics/haptics/scenes/plot_part.h"
#include "tactics/haptics/simulated/arm.h"
#include "tactics/haptics/simulated/hand.h"

namespace tactics {

/// --arm, --finger, --rate.
ArmFile arm_of(const Given& given);
/// --plane; nothing if it is not given.
std::optional<ScenePlane> plane_of(const Given& given);
/// --feel; all parts if it is not given.
std::vector<const PlotPart*> parts_of(const Given& given);
/// --fixture.
FixtureSettings fixture_of(const Given& given);
/// --hand.
const HandKind& hand_of(const Given& given);
/// --stiffness, --damping. The defaults are the largest stable values of the arm, or `share` of them if several things may push
/// the same way. Throws Error(usage) with the nearest stable values.
ForceLaw arm_law_of(const Given& given, const ArmFile& file, double share);

}  // namespace tactics
