// SPDX-License-Identifier: Apache-2.0
// The displays of `show`: a pin display on a serial line, or one with braille cells.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "print/format.h"
#include "tactics/transport/cell_display.h"
#include "tactics/transport/delivery.h"

namespace tactics {

class Screen {
public:
    virtual ~Screen() = default;
    /// The format and the settings with which to lay out a page for it.
    virtual const Format& format() const = 0;
    virtual const Settings& settings() const = 0;
    /// false: it did not confirm. Throws Error(failed) if it is gone or refuses.
    virtual bool show(const Page& page) = 0;
    /// Whether one of its keys was pressed within that time. Throws Error(failed) if it is gone.
    virtual bool key_within(std::chrono::milliseconds time) = 0;
    /// The display keeps its contents when the program ends.
    virtual bool keeps() const = 0;
};

/// `format` has a PinDisplay. Asks the display for its size, which overrides the settings. Throws Error(failed) if there is no
/// answer or there are no pins.
std::unique_ptr<Screen> pin_screen(const Format& format, const Settings& settings, std::unique_ptr<Channel> channel,
                                   const std::string& place);

/// Throws Error(failed) for a size that no page can be laid out on.
std::unique_ptr<Screen> cell_screen(std::unique_ptr<CellDisplay> display, bool keeps, const std::string& place);

}  // namespace tactics
