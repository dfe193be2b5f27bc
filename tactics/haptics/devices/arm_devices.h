// SPDX-License-Identifier: Apache-2.0
// Arms: they know the finger's position and push it in space. All real arms use the same axes here, whatever their makers use: x
// to the right, y upwards, z towards the person (`place` and `height` of a sample), in mm from an origin of the arm's own, and N.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "tactics/haptics/devices/haptic_device.h"

namespace tactics {

/// Haply's Inverse3, Inverse3x or Minverse by the Inverse Service of this machine (inverse3_messages.h). `where` is "", a port or
/// "localhost:10001", optionally followed by "/" and the id of the device. The origin is the middle of its reach. Throws
/// Error(usage) for another machine or an invalid port; Error(failed) for no service, no device, or several of which none is
/// named.
///
/// A separate thread talks to the service. A requested force holds for 10 ms, then becomes zero, as it does after let_go, which
/// waits for the service's answer. After half a second without an answer, with invalid answers or with the device unplugged, it
/// counts as gone.
std::unique_ptr<HapticDevice> inverse3_arm(const std::string& where);

/// Arms of Force Dimension and the Novint Falcon through libdhd of Force Dimension's SDK: the system's library ("") or the one at
/// a path. The origin is the maker's. Throws Error(failed) for a missing library or device.
std::unique_ptr<HapticDevice> force_dimension_arm(const std::string& library);
/// The Touch and related devices through libHD of 3D Systems' OpenHaptics; the same.
std::unique_ptr<HapticDevice> openhaptics_arm(const std::string& library);

/// A recorded path (recorded_way.h), with heights, in the axes of the scene; forces do not move it. Throws Error(failed).
std::unique_ptr<HapticDevice> recorded_arm(std::string_view csv, const std::string& name);

}  // namespace tactics
