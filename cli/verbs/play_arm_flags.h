// SPDX-License-Identifier: Apache-2.0
// What a play on an arm was asked for, flag by flag. Each function throws Error(usage) where its flag is not understood.
#pragma once

#include <vector>

#include "cli/command.h"
#include "tactics/haptics/devices/mounting.h"
#include "tactics/haptics/scenes/fixture.h"
#include "tactics/haptics/scenes/force_law.h"
#include "tactics/haptics/scenes/plot_part.h"
#include "tactics/haptics/simulated/arm.h"
#include "tactics/haptics/simulated/hand.h"
#include "tactics/plot.h"

namespace tactics {

/// --arm, --finger, --rate.
ArmFile arm_of(const Given& given);
/// --plane. A surface lies on a table, as a relief does; curves are on a wall, as in the paper.
ScenePlane plane_of(const Given& given, const Plot& plot);
/// --feel; all parts where it is not given.
std::vector<const PlotPart*> parts_of(const Given& given);
/// --fixture.
FixtureSettings fixture_of(const Given& given);
/// --hand.
const HandKind& hand_of(const Given& given);
/// --stiffness, --damping: what nobody named is what the arm bears. Throws Error(usage) with the nearest that it does.
ForceLaw arm_law_of(const Given& given, const ArmFile& file);

}  // namespace tactics
