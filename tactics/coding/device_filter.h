// SPDX-License-Identifier: Apache-2.0
// Soft encoding: what a device cannot tell apart or give is taken away before anything is encoded. Without it an encoding is
// strong: as the source has it, for any device.
//
// K. Moustakas, "Handling haptics as a stand-alone medium" (WSCG 2013): a device is a filter that quantises places by its
// resolution and forces by what it can give (section 4); an encoder that knows it need not send the rest ("alternative soft HR
// system").
#pragma once

#include "tactics/coding/level_map.h"
#include "tactics/coding/recording.h"

namespace tactics {

struct DeviceSteps {
    double place = 0;       ///< mm, its resolution
    double force = 0;       ///< N
    double most_force = 0;  ///< N
};

/// Places and forces to the nearest step, forces no larger than the device gives, in their direction.
Recording for_device(const Recording& recording, const DeviceSteps& device);

/// No more levels than the device tells apart between the lowest and the highest: a height moves by at most half its resolution.
LevelMap for_device(LevelMap map, const DeviceSteps& device);

}  // namespace tactics
