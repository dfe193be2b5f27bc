// The mouse, the lever and the finger that play is asked for.
#pragma once

#include <memory>
#include <string>

#include "tactics/haptics/lever.h"
#include "tactics/haptics/mouse_device.h"
#include "tactics/haptics/relief_surface.h"

namespace tactics {

/// "light", "heavy", or a file of its numbers. Throws Error.
LeverSettings lever_of(const std::string& name);
/// "soft", "nominal", "stiff". Throws Error(usage).
FingerSettings finger_of(const std::string& name);

struct DeviceWish {
    std::string name;  ///< "simulated", "recorded:FILE", "hid:", "hid:/dev/hidraw0"
    LeverSettings lever;
    FingerSettings finger;
    const ReliefSurface& surface;  ///< where a simulated hand moves
    double speed = 50;             ///< mm/s
    double seconds = 10;
    double counts_per_mm = 31.5;
};
/// Throws Error.
std::unique_ptr<MouseDevice> open_mouse(const DeviceWish& wish);

}  // namespace tactics
