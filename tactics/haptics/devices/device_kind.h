// SPDX-License-Identifier: Apache-2.0
// The description of a kind of haptic device. The kinds are in a list (list.inc), one per line.
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

/// The purpose for which a device is opened; a real arm uses only `where`.
struct DeviceWish {
    std::string where;  ///< the part after its name and a colon: a file, a device; may be empty
    MouseSettings machine;
    const ReliefSurface* surface = nullptr;  ///< the surface on which a simulated hand moves; set for a mouse
    int axes = 1;                            ///< 1: up and down on a map, 3: in space
    double speed = 50;                       ///< mm/s, of a simulated hand
    double seconds = 10;
    ArmFile arm = {};        ///< of a simulated arm
    Mounting mounting = {};  ///< position of the scene in its workspace
    Hand* hand = nullptr;    ///< the hand that moves it
};

struct DeviceKind {
    std::string_view name = {};     ///< "recorded", as it is typed
    std::string_view address = {};  ///< what may follow it after a colon: "FILE.csv"; empty: nothing
    std::string_view example = {};  ///< "recorded:FILE.csv"
    bool has_hand = false;          ///< a simulated hand moves it, at the given speed
    bool finds_place = false;       ///< its place comes from sensors, by fusion; other kinds know it
    bool knows_truth = false;       ///< it finds its place, but the true position of the finger is also known
    bool ends = false;              ///< it plays for a given time; other kinds until they end or are stopped
    bool real = false;              ///< a person's finger is on it
    int axes = 1;  ///< 1: a mouse, which lifts; 3: an arm, which pushes in any direction (arm_devices.h); 0: either, as requested
    /// Throws Error for a missing file or device, or invalid contents.
    std::unique_ptr<HapticDevice> (*open)(const DeviceWish& wish) = nullptr;
};

std::span<const DeviceKind* const> device_kinds();  ///< the first is the default

}  // namespace tactics
