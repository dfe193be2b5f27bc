// SPDX-License-Identifier: Apache-2.0
// Attached devices that could be an embosser, or a braille display of the HID standard.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/text/phrase.h"

namespace tactics {

struct AttachedDevice {
    std::string address;  ///< as parse_address takes it, but those of displays
    std::string id;       ///< its IEEE-1284 id, or maker and product; empty: it does not tell
    Phrase note;          ///< why it cannot be used now, and the remedy, or how to use it; may be empty
};

/// Printers on USB, serial adapters and braille displays (hid:/dev/hidraw0), as the kernel lists them below `root` ("" but in
/// tests), then print queues, by lpstat where that is installed. Nothing is opened or sent.
std::vector<AttachedDevice> attached_devices(const std::string& root);
std::vector<AttachedDevice> print_queues();
/// Those in what `lpstat -v` writes, "device for NAME: URI" a line.
std::vector<AttachedDevice> queues_told(std::string_view lpstat);

/// The IEEE-1284 id of a printer, /dev/usb/lp0; empty if it does not tell.
std::string printer_id(const std::string& path, const std::string& root);

}  // namespace tactics
