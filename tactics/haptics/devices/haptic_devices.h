// SPDX-License-Identifier: Apache-2.0
// The haptic mice and touch overlays that are there, beside the printers and displays of transport/devices.h.
#pragma once

#include <string>
#include <vector>

#include "tactics/transport/devices.h"

namespace tactics {

/// Mice (hid:/dev/hidraw0), then overlays (/dev/input/event5), as the kernel lists them below `root` ("" but in tests), with what
/// to write for each. Nothing is opened or sent.
std::vector<AttachedDevice> haptic_devices(const std::string& root);

}  // namespace tactics
