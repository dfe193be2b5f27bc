// SPDX-License-Identifier: Apache-2.0
// A scene on an arm and the way of the finger in it, seen from the front and from above.
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

/// From the front, heights upwards, and from above, what is nearer to the person further down; x to the right in both. Onto its
/// plane a surface, a relief or a model is its contours, or the lines that it was drawn with; along it, its upper outline, and a
/// curve is a line at 0, as long as it.
std::vector<Plot> arm_views(const ArmScene& scene, const std::vector<TickRecord>& records, ArmView view);

}  // namespace tactics
