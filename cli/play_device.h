// SPDX-License-Identifier: Apache-2.0
// The mouse and the machine that play is asked for.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "cli/command.h"
#include "tactics/haptics/devices/mouse_device.h"
#include "tactics/haptics/scenes/relief_surface.h"
#include "tactics/haptics/sensing/touch_overlay.h"
#include "tactics/haptics/simulated/lever_file.h"

namespace tactics {

/// --lever, --finger, --rate, with the delay and the finger that are taken for a real mouse where nothing tells them. Throws
/// Error.
MouseSettings machine_of(const Given& given);
/// "600x340mm", "20mm,30mm": two lengths; a unit at the end is that of both.
std::optional<Point> two_lengths(std::string_view text, char between);

/// "simulated", "sensed", "recorded", "hid": of the name of a mouse. Throws Error(usage): there is no such.
std::string kind_of_mouse(const std::string& name);
/// Of --device: it is no simulation.
bool is_real_mouse(const Given& given);

struct OverlayWish {
    std::string name;  ///< "auto", "/dev/input/event0"
    OverlayPlace place;
};
/// --overlay, --overlay-size, --map-at, which go with a real mouse. Throws Error(usage).
std::optional<OverlayWish> overlay_of(const Given& given);

struct DeviceWish {
    std::string name;  ///< "simulated", "sensed", "recorded:FILE", "hid:", "hid:/dev/hidraw0"
    MouseSettings machine;
    const ReliefSurface& surface;  ///< where a simulated hand moves
    double speed = 50;             ///< mm/s
    double seconds = 10;
    std::optional<OverlayWish> overlay = {};  ///< of a real mouse; says when it is gone and when it is there again
};
/// Throws Error.
std::unique_ptr<MouseDevice> open_mouse(const DeviceWish& wish);

}  // namespace tactics
