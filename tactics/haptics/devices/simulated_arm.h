// SPDX-License-Identifier: Apache-2.0
// A simulated arm that a simulated hand moves (simulated/).
#pragma once

#include <memory>

#include "tactics/haptics/devices/haptic_device.h"
#include "tactics/haptics/devices/mounting.h"
#include "tactics/haptics/simulated/arm.h"
#include "tactics/haptics/simulated/hand.h"

namespace tactics {

/// It knows its position, in its own axes. The hand, which must outlive it, uses those of the scene; an arm whose file has no
/// finger is not moved. It ends after `seconds`, or when the hand is done.
std::unique_ptr<HapticDevice> simulated_arm(const ArmFile& arm, const Mounting& mounting, Hand& hand, double seconds);

}  // namespace tactics
