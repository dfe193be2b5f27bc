// SPDX-License-Identifier: Apache-2.0
// A display of braille cells that a driver of the system or the HID standard knows.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace tactics {

struct CellDisplaySize {
    int columns = 0;  ///< cells of a line
    int lines = 0;
    int dots = 8;  ///< of a cell, 6 or 8
};

/// BrlAPI's answer about its display, which has 8 dots. An impossible number (over a million) becomes 0.
CellDisplaySize told_size(unsigned columns, unsigned lines);

class CellDisplay {
public:
    virtual ~CellDisplay() = default;
    virtual CellDisplaySize size() const = 0;
    /// Line by line, columns * lines of them; bit 0 = dot 1 ... bit 7 = dot 8. Throws Error(failed): gone.
    virtual void show(std::span<const std::uint8_t> cells) = 0;
    /// Whether a key of it was pressed within that time. Throws Error(failed): gone.
    virtual bool key_within(std::chrono::milliseconds time) = 0;
};

/// The braille display of a screen reader, by the BrlAPI of BRLTTY: on this machine (""), or at "HOST:PORT" in BrlAPI's notation.
/// Throws Error(failed) if its library is not installed, there is no answer within `patience` now or later, or there is no
/// display.
std::unique_ptr<CellDisplay> open_brlapi(const std::string& host, std::chrono::milliseconds patience = std::chrono::seconds(10));

/// A braille display of the HID standard (usage page 41h): "" = the only one attached, or "/dev/hidraw0". Throws Error(failed).
std::unique_ptr<CellDisplay> open_hid_display(const std::string& path);

}  // namespace tactics
