// SPDX-License-Identifier: Apache-2.0
// Lists the attached haptic mice and touch overlays; transport/devices.h lists printers and displays.
#pragma once

#include <string>
#include <vector>

#include "tactics/transport/devices.h"

namespace tactics {

/// Mice (hid:/dev/hidraw0), then overlays (/dev/input/event5), as the kernel lists them below `root` ("" except in tests), with
/// the option to use for each. Nothing is opened or sent.
std::vector<AttachedDevice> haptic_devices(const std::string& root);

}  // namespace tactics
