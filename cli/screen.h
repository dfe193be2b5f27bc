// What show shows pages on: a display of pins on a serial line, or one of braille cells.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "print/format.h"

namespace tactics {

class Screen {
public:
    virtual ~Screen() = default;
    /// The format and the settings that a page for it is laid out with.
    virtual const Format& format() const = 0;
    virtual const Settings& settings() const = 0;
    /// Throws Error(failed): gone, refused, or no answer.
    virtual void show(const Page& page) = 0;
    /// Whether a key of it was pressed within that time. Throws Error(failed).
    virtual bool key_within(std::chrono::milliseconds time) = 0;
    /// What was shown stays when the program ends.
    virtual bool keeps() const = 0;
};

/// "dot-pad:/dev/ttyUSB0", "graphiti:/dev/ttyACM0", "hid:", "hid:/dev/hidraw0", "brlapi:" or "brlapi:HOST:0". `sets` are all values of --set, those of the display count;
/// what the display tells of itself counts more. Throws Error.
std::unique_ptr<Screen> open_screen(const std::string& address, const std::vector<std::string>& sets, const std::string& place);

}  // namespace tactics
