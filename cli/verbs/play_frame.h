// SPDX-License-Identifier: Apache-2.0
// Where a plot is in the workspace of an arm.
#pragma once

#include "tactics/haptics/devices/mounting.h"
#include "tactics/haptics/scenes/plot_frame.h"
#include "tactics/haptics/simulated/arm.h"
#include "tactics/plot.h"

namespace tactics {

/// The axes that a plot has under a finger, in a field with `room` mm over it.
PlotFrame frame_of(const Plot& plot, const MountedField& field, double room);

/// mm that the workspace has over the plane, on the finger's side, less the margin.
double room_over(const MountedField& field, const ArmSettings& arm, double margin);

}  // namespace tactics
