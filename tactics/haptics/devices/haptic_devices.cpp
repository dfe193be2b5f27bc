// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/devices/haptic_devices.h"

#include <unistd.h>

#include "tactics/error.h"
#include "tactics/haptics/devices/mouse_report.h"
#include "tactics/transport/hid_displays.h"
#include "tactics/transport/hid_reports.h"
#include "tactics/transport/kernel_lists.h"
#include "tactics/transport/touch_device.h"

namespace tactics {

namespace {

// `permission`: what to do if it may not be opened.
Phrase with_hindrance(Phrase note, const std::string& root, const std::string& path, int mode, const Phrase& permission) {
    if (const Phrase missing = note_if_missing(root, path); !missing.empty()) return phrase("{0}; {1}", std::move(note), missing);
    return access((root + path).c_str(), mode) != 0 ? phrase("{0}; {1}", std::move(note), permission) : note;
}

}  // namespace

std::vector<AttachedDevice> haptic_devices(const std::string& root) {
    std::vector<AttachedDevice> devices;
    for (const std::string& path : hid_paths(kMouseUsagePage, kMouseUsage, root))
        devices.push_back({"hid:" + path, hid_name(path, root),
                           with_hindrance(phrase("haptic mouse: play {0} hid:{1}", spelled("device"), path), root, path,
                                          R_OK | W_OK, how_to_be_permitted(path, root))});
    for (const TouchPlace& place : touch_places(root))
        devices.push_back({place.path, place.name,
                           with_hindrance(phrase("touch overlay or touch screen: play {0} {1}", spelled("overlay"), place.path),
                                          root, place.path, R_OK, how_to_be_permitted_to_touch(place.path))});
    return devices;
}

}  // namespace tactics
