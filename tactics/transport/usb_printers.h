// SPDX-License-Identifier: Apache-2.0
// USB printers as listed by the kernel, with any driver, and the names by which to choose one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tactics {

struct UsbPrinter {
    std::string place;            ///< as in /sys/bus/usb/devices: 1-2.3
    std::string vendor, product;  ///< four hexadecimal digits each
    std::string serial;           ///< empty: it has none
    std::string name;             ///< maker and product; empty: it does not tell
    std::string driver;           ///< of its interface for printing: usblp; usbfs is another program; empty: none
    std::string path;             ///< of that driver: /dev/usb/lp0; empty: none
    int bus = 0, number = 0;      ///< of /dev/bus/usb/BUS/NUMBER
    std::string node() const;
};

/// Below `root` ("" but in tests). Nothing is opened.
std::vector<UsbPrinter> usb_printers(const std::string& root);

/// Whether that may follow "usb:": nothing, VID:PID, VID:PID:SERIAL or BUS-PORT.
bool is_usb_choice(std::string_view choice);

/// The chosen printer. Throws Error(failed) if there is none, or several, which the message lists.
UsbPrinter usb_printer(const std::string& choice, const std::string& root);

}  // namespace tactics
