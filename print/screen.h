// SPDX-License-Identifier: Apache-2.0
// What show shows pages on: a display of pins on a line, or one of braille cells.
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
    /// The format and the settings that a page for it is laid out with.
    virtual const Format& format() const = 0;
    virtual const Settings& settings() const = 0;
    /// false: it did not say that it shows it. Throws Error(failed): gone, or refused.
    virtual bool show(const Page& page) = 0;
    /// Whether a key of it was pressed within that time. Throws Error(failed): gone.
    virtual bool key_within(std::chrono::milliseconds time) = 0;
    /// What was shown stays when the program ends.
    virtual bool keeps() const = 0;
};

/// `format` has a PinDisplay. It is asked how large it is; what it tells counts more than the settings. Throws Error(failed): no
/// answer, no pins.
std::unique_ptr<Screen> pin_screen(const Format& format, const Settings& settings, std::unique_ptr<Channel> channel,
                                   const std::string& place);

/// Throws Error(failed) for a size that no page can be laid out on.
std::unique_ptr<Screen> cell_screen(std::unique_ptr<CellDisplay> display, bool keeps, const std::string& place);

}  // namespace tactics
