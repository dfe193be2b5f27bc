// SPDX-License-Identifier: Apache-2.0
// What a play on an arm was asked for, flag by flag. Each function throws Error(usage) where its flag is not understood.
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
/// --plane; nothing where it is not given.
std::optional<ScenePlane> plane_of(const Given& given);
/// --feel; all parts where it is not given.
std::vector<const PlotPart*> parts_of(const Given& given);
/// --fixture.
FixtureSettings fixture_of(const Given& given);
/// --hand.
const HandKind& hand_of(const Given& given);
/// --stiffness, --damping: what nobody named is what the arm bears, or `share` of that where several things may push the same
/// way. Throws Error(usage) with the nearest that it does.
ForceLaw arm_law_of(const Given& given, const ArmFile& file, double share);

}  // namespace tactics
