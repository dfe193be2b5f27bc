// SPDX-License-Identifier: Apache-2.0
// A touch device of the kernel (evdev): a touch screen or an infrared frame.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tactics/text/phrase.h"
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
    /// The next frame; nothing: no more frames yet. Does not wait or allocate.
    virtual State read(TouchFrame& frame) noexcept = 0;
};

/// That the user may not open it, and what to do.
Phrase how_to_be_permitted_to_touch(const std::string& path);

/// Opens it by path, /dev/input/event0, for exclusive use if possible. Throws Error(failed) if it is missing, not permitted, or
/// no touch device.
std::unique_ptr<TouchDevice> open_touch_device(const std::string& path);

struct TouchPlace {
    std::string path, name;
};
/// Those that are touched where they show (INPUT_PROP_DIRECT: no touch pads), as the kernel lists them below `root` ("" but in
/// tests).
std::vector<TouchPlace> touch_places(const std::string& root);

}  // namespace tactics
