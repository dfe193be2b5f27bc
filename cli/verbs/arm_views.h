// SPDX-License-Identifier: Apache-2.0
// A scene on an arm and the finger's path in it, seen from the front and from above.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cli/command.h"
#include "cli/verbs/arm_scene.h"
#include "tactics/haptics/loop/recorder.h"
#include "tactics/plot.h"

namespace tactics {

enum class ArmView : std::uint8_t { both, front, above };
/// --view. Throws Error(usage).
ArmView view_of(const Given& given);
std::size_t pages_of(ArmView view);

/// From the front with heights upwards, and from above with parts nearer to the person further down; x points to the right in
/// both. Seen onto its plane, a surface, a relief or a model is drawn by its contours, or by the lines of its drawing; seen along
/// the plane, by its upper outline, and a curve by a line at 0 of its length.
std::vector<Plot> arm_views(const ArmScene& scene, const std::vector<TickRecord>& records, ArmView view);

}  // namespace tactics
