// SPDX-License-Identifier: Apache-2.0
// The haptic mice: those that are simulated, one that repeats a recorded way, and one that is there.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "tactics/haptics/devices/haptic_device.h"
#include "tactics/haptics/simulated/lever.h"

namespace tactics {

/// A lever with a finger on it, or none (lever.h), that a hand moves over the middle of the map, from its left edge, where it
/// rests for half a second, to its right and back, at that speed (mm/s), until `seconds` are over. It knows its place.
std::unique_ptr<HapticDevice> simulated_mouse(const LeverSettings& lever, const std::optional<FingerSettings>& finger,
                                              double width, double height, double begin_height, double speed, double seconds);

/// The same lever and finger, but the hand rests at either edge, and the mouse does not know its place: it tells what its sensors
/// counted and where a late overlay saw it, with all that is wrong with both (all_causes()). `rate`: of the loop that it is for,
/// Hz; `seconds` are at most kMostSensed.
struct SensedWish {
    MouseGeometry geometry;
    double width = 0, height = 0;  ///< of the map, mm
    double begin_height = 0;       ///< of the finger, mm
    double speed = 50;             ///< mm/s
    double seconds = 10;
    double rate = 1000;
};
inline constexpr double kMostSensed = 600;  // s
std::unique_ptr<HapticDevice> sensed_mouse(const LeverSettings& lever, const std::optional<FingerSettings>& finger,
                                           const SensedWish& wish);

/// A way that was recorded (recorded_way.h) under the finger of a simulated lever; where it has a height, that is the finger's
/// own, and the lever is not simulated. Throws Error(failed) as read_way does.
std::unique_ptr<HapticDevice> recorded_mouse(std::string_view csv, const std::string& name, const LeverSettings& lever,
                                             const std::optional<FingerSettings>& finger, double begin_height);

/// What its counts are.
struct HidMouseSettings {
    double encoder_step = 0.0146;  ///< mm a count, upwards
    double counts_per_mm = 31.5;   ///< of the optical sensors: 800 an inch
    bool operator==(const HidMouseSettings&) const = default;
};

/// s from what a mouse measures to a force that answers it, in the mean, where nobody has measured it: what it tells, the tick
/// that takes it and the force each wait up to 1 ms for their turn.
inline constexpr double kHidDelay = 0.0015;

/// By reports of mouse_report.h, on hidraw: "" = the only one that is there, or its path. Throws Error(failed).
std::unique_ptr<HapticDevice> hid_mouse(const std::string& path, const HidMouseSettings& settings);

}  // namespace tactics
