// The mouse and the machine that play is asked for.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cli/command.h"
#include "tactics/haptics/lever_file.h"
#include "tactics/haptics/mouse_device.h"
#include "tactics/haptics/relief_surface.h"
#include "tactics/haptics/touch_overlay.h"

namespace tactics {

/// `lever` is "light", "heavy", or a file of the machine's numbers; `finger` "soft", "nominal", "stiff", or "" for that of the file, and
/// the nominal one where there is no file. Throws Error.
MouseSettings machine_of(const std::string& lever, const std::string& finger);

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
