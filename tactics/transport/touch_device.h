// SPDX-License-Identifier: Apache-2.0
// A device that sees where it is touched, as the kernel tells of it (evdev): a touch screen, an infrared frame.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tactics/transport/touch_contacts.h"

namespace tactics {

struct TouchAxis {
    int least = 0, most = 0;  ///< in its units, from left to right and from the top down
    double per_mm = 0;        ///< units; 0: it does not tell
};

struct TouchFrame {
    double time = 0;                         ///< s, CLOCK_MONOTONIC, when the kernel heard of it
    std::span<const TouchContact> contacts;  ///< all that are down; holds until the next is read
};

class TouchDevice {
public:
    enum class State { nothing, frame, gone };
    virtual ~TouchDevice() = default;
    virtual TouchAxis x() const = 0;
    virtual TouchAxis y() const = 0;
    /// The next frame; nothing: it has told no more. Never waits, never allocates.
    virtual State read(TouchFrame& frame) noexcept = 0;
};

/// That the user may not open it, and what to do.
std::string how_to_be_permitted_to_touch(const std::string& path);

/// By its path, /dev/input/event0. Until it is closed no other program is told of its touches, if it can be had so. Throws
/// Error(failed): missing, not permitted, no touch device.
std::unique_ptr<TouchDevice> open_touch_device(const std::string& path);

struct TouchPlace {
    std::string path, name;
};
/// Those that are touched where they show (INPUT_PROP_DIRECT: no touch pads), as the kernel lists them below `root` ("" but in
/// tests).
std::vector<TouchPlace> touch_places(const std::string& root);

}  // namespace tactics
