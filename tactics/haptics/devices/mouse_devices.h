// SPDX-License-Identifier: Apache-2.0
// The haptic mice: simulated ones, one that repeats a recorded path, and a real one.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "tactics/haptics/devices/haptic_device.h"
#include "tactics/haptics/simulated/lever.h"

namespace tactics {

/// A lever with a finger on it, or none (lever.h). A hand moves it over the middle of the map, from the left edge, where it rests
/// for half a second, to the right and back, at that speed (mm/s), until `seconds` are over. It knows its place.
std::unique_ptr<HapticDevice> simulated_mouse(const LeverSettings& lever, const std::optional<FingerSettings>& finger,
                                              double width, double height, double begin_height, double speed, double seconds);

/// The same lever and finger, but the hand rests at both edges, and the mouse does not know its place: it reports the counts of
/// its sensors and the place seen by a late overlay, with all the errors of both (all_causes()). `rate`: that of the loop, Hz;
/// `seconds` are at most kMostSensed.
struct SensedWish {
    MouseGeometry geometry;
    double width = 0, height = 0;  ///< of the map, mm
    double begin_height = 0;       ///< initial height of the finger, mm
    double speed = 50;             ///< mm/s
    double seconds = 10;
    double rate = 1000;
};
inline constexpr double kMostSensed = 600;  // s
std::unique_ptr<HapticDevice> sensed_mouse(const LeverSettings& lever, const std::optional<FingerSettings>& finger,
                                           const SensedWish& wish);

/// A recorded path (recorded_way.h) under the finger of a simulated lever; if the path has a height, it is the finger's own, and
/// the lever is not simulated. Throws Error(failed) as read_way does.
std::unique_ptr<HapticDevice> recorded_mouse(std::string_view csv, const std::string& name, const LeverSettings& lever,
                                             const std::optional<FingerSettings>& finger, double begin_height);

/// The meaning of its counts.
struct HidMouseSettings {
    double encoder_step = 0.0146;  ///< mm per count, upwards
    double counts_per_mm = 31.5;   ///< of the optical sensors: 800 an inch
    bool operator==(const HidMouseSettings&) const = default;
};

/// s from a mouse's measurement to the resulting force, on average, for mice on which nobody has measured it: the report, the
/// tick that takes it and the force each wait up to 1 ms for their turn.
inline constexpr double kHidDelay = 0.0015;

/// A real mouse with the reports of mouse_report.h, on hidraw: "" = the only one attached, or its path. Throws Error(failed).
std::unique_ptr<HapticDevice> hid_mouse(const std::string& path, const HidMouseSettings& settings);

}  // namespace tactics
