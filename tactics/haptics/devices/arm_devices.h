// SPDX-License-Identifier: Apache-2.0
// Arms: they know where the finger is and push it in space. Those that are there all tell and take the same axes, whatever their
// makers' are: x to the right, y upwards, z towards the person (`place` and `height` of a sample), in mm from an origin of the
// arm's own, and N.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "tactics/haptics/devices/haptic_device.h"

namespace tactics {

/// A way that was recorded (recorded_way.h), with heights, in the axes of what is felt; nothing moves it. Throws Error(failed).
std::unique_ptr<HapticDevice> recorded_arm(std::string_view csv, const std::string& name);

}  // namespace tactics
