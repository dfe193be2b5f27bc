// The mouse and the machine that play is asked for.
#pragma once

#include <memory>
#include <string>

#include "tactics/haptics/lever_file.h"
#include "tactics/haptics/mouse_device.h"
#include "tactics/haptics/relief_surface.h"

namespace tactics {

/// `lever` is "light", "heavy", or a file of the machine's numbers; `finger` "soft", "nominal", "stiff", or "" for that of the file, and
/// the nominal one where there is no file. Throws Error.
MouseSettings machine_of(const std::string& lever, const std::string& finger);

struct DeviceWish {
    std::string name;  ///< "simulated", "sensed", "recorded:FILE", "hid:", "hid:/dev/hidraw0"
    MouseSettings machine;
    const ReliefSurface& surface;  ///< where a simulated hand moves
    double speed = 50;             ///< mm/s
    double seconds = 10;
};
/// Throws Error.
std::unique_ptr<MouseDevice> open_mouse(const DeviceWish& wish);

}  // namespace tactics
