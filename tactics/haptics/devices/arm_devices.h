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

/// Haply's Inverse3, Inverse3x or Minverse by the Inverse Service of this machine (inverse3_messages.h). `where` is "", a port,
/// "localhost:10001", and perhaps "/" and the id of the device. The origin is the middle of what it reaches. Throws Error(usage):
/// another machine, no port; Error(failed): no service, no device, or several of which none is named.
///
/// A thread of its own talks with the service. A wish for a force holds for 10 ms, then the force is zero, as it is from let_go
/// on, which waits until the service has answered that. No answer for half a second, nonsense, or the device unplugged for as
/// long: it is gone.
std::unique_ptr<HapticDevice> inverse3_arm(const std::string& where);

/// Arms of Force Dimension and the Novint Falcon by libdhd, as Force Dimension's SDK has it: the library of the system ("") or
/// that at a path. The origin is the maker's. Throws Error(failed): no such library, no device.
std::unique_ptr<HapticDevice> force_dimension_arm(const std::string& library);
/// The Touch and its kin by 3D Systems' OpenHaptics, libHD; the same.
std::unique_ptr<HapticDevice> openhaptics_arm(const std::string& library);

/// A way that was recorded (recorded_way.h), with heights, in the axes of what is felt; nothing moves it. Throws Error(failed).
std::unique_ptr<HapticDevice> recorded_arm(std::string_view csv, const std::string& name);

}  // namespace tactics
