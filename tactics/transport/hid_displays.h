// Braille displays of the HID standard, as the kernel lists them.
#pragma once

#include <string>
#include <vector>

#include "tactics/transport/braille_reports.h"

namespace tactics {

struct HidDisplay {
    std::string path;  ///< /dev/hidraw0
    std::string name;
    BrailleReports reports;
};

/// Below `root` ("" but in tests). Nothing is opened.
std::vector<HidDisplay> hid_displays(const std::string& root);

/// "" = the only one; else its path, or a link to it. Throws Error(failed): none, several, or it is another thing.
HidDisplay hid_display(const std::string& path, const std::string& root);

}  // namespace tactics
