// SPDX-License-Identifier: Apache-2.0
// The parameters of a haptic mouse and of the finger on it, in a text file that anyone can edit.
//
//     # a heavier lever, another finger
//     lever = heavy
//     lever.delay = 0.001 s
//     finger = soft
//     finger.preload = 0.8 N
//     sensors.apart = 52 mm
//
// `lever` and `finger` take one of the presets (lever.h), `finger` also none, and come before settings that change parts of them.
// `#` starts a comment. Settings that are not named keep their defaults.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tactics/haptics/sensing/fusion.h"
#include "tactics/haptics/simulated/lever.h"

namespace tactics {

/// Positions and resolution of the optical sensors at its bottom.
struct SensorSettings {
    double apart = 60;            ///< mm, from the first, on the left, to the second
    double counts_per_mm = 31.5;  ///< 800 an inch
    double finger_across = 0;     ///< mm, position of the fingertip to the right of the middle between them
    double finger_ahead = 80;     ///< mm, away from the hand
    bool operator==(const SensorSettings&) const = default;
};
inline MouseGeometry geometry_of(const SensorSettings& sensors) {
    return {sensors.apart, {sensors.finger_across, -sensors.finger_ahead}};
}

struct MouseSettings {
    LeverSettings lever;
    FingerSettings finger;
    SensorSettings sensors;
    bool lifted = false;  ///< no finger is on it: `finger = none`
    /// The lever and the finger of a simulation.
    std::optional<FingerSettings> on_it() const { return lifted ? std::nullopt : std::optional(finger); }
    bool operator==(const MouseSettings&) const = default;
};

/// `origin` is the file's name for messages. Throws Error(usage) with the line for an unknown name, an invalid number, unit or
/// range, and a repeated name.
MouseSettings read_mouse(std::string_view text, std::string_view origin);

/// All parameters, one per line with its unit, followed by range and meaning as a comment; read_mouse reads them back to within
/// 1e-6.
std::string to_text(const MouseSettings& mouse);

}  // namespace tactics
