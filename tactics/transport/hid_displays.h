// SPDX-License-Identifier: Apache-2.0
// Braille displays of the HID standard, as the kernel lists them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/text/phrase.h"
#include "tactics/transport/braille_reports.h"

namespace tactics {

struct HidDisplay {
    std::string path;  ///< /dev/hidraw0
    std::string name;
    BrailleReports reports;
    std::string kernel_id = {};  ///< HID_ID, "0003:00001209:0000ABCD": bus, vendor, product
};

/// Below `root` ("" but in tests). Nothing is opened.
std::vector<HidDisplay> hid_displays(const std::string& root);

/// "" = the only one; else its path, or a link to it. Throws Error(failed): none, several, or it is another thing.
HidDisplay hid_display(const std::string& path, const std::string& root);

/// The line for udev that permits the one who sits there to use a device with that HID_ID; empty: the kernel does not tell its
/// numbers.
std::string udev_rule(std::string_view kernel_id);

/// That the user may not open it, and what to do: for now, and the udev rule of that device for good.
Phrase how_to_be_permitted(const HidDisplay& display);
/// The same for a device with our own reports, by its path.
Phrase how_to_be_permitted(const std::string& path, const std::string& root);

}  // namespace tactics
