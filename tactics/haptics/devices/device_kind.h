// SPDX-License-Identifier: Apache-2.0
// What a kind of haptic device says of itself. The kinds are in a list (list.inc), one a line.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "tactics/haptics/devices/haptic_device.h"
#include "tactics/haptics/devices/mounting.h"
#include "tactics/haptics/scenes/relief_surface.h"
#include "tactics/haptics/simulated/arm.h"
#include "tactics/haptics/simulated/hand.h"
#include "tactics/haptics/simulated/lever_file.h"

namespace tactics {

/// What a device is opened for; an arm that is there asks for `where` alone.
struct DeviceWish {
    std::string where;  ///< what stands behind its name and a colon: a file, a device; may be empty
    MouseSettings machine;
    const ReliefSurface* surface = nullptr;  ///< where a simulated hand moves; a mouse has one
    int axes = 1;                            ///< what is to be felt with it: 1 up and down on a map, 3 in space
    double speed = 50;                       ///< mm/s, of a simulated hand
    double seconds = 10;
    ArmFile arm = {};        ///< of a simulated arm
    Mounting mounting = {};  ///< where the scene is in it
    Hand* hand = nullptr;    ///< that moves it
};

struct DeviceKind {
    std::string_view name = {};     ///< "recorded", as it is typed
    std::string_view address = {};  ///< what may stand behind it and a colon: "FILE.csv"; empty: nothing
    std::string_view example = {};  ///< "recorded:FILE.csv"
    bool has_hand = false;          ///< a simulated hand moves it, as quickly as it is told
    bool finds_place = false;       ///< its place comes from sensors, by fusion; the others know it
    bool knows_truth = false;       ///< although it finds its place, it is known where the finger truly is
    bool ends = false;              ///< it is played for a time; the others until they are over or stopped
    bool real = false;              ///< somebody's finger is on it
    int axes = 1;  ///< 1: a mouse, which lifts; 3: an arm, which pushes any way (arm_devices.h); 0: either, as it is wished for
    /// Throws Error: no such file or device, or what is in it.
    std::unique_ptr<HapticDevice> (*open)(const DeviceWish& wish) = nullptr;
};

std::span<const DeviceKind* const> device_kinds();  ///< the first is taken where none is named

}  // namespace tactics
