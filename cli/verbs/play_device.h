// SPDX-License-Identifier: Apache-2.0
// The mouse and the machine for play.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "cli/command.h"
#include "tactics/haptics/devices/device_kind.h"
#include "tactics/haptics/sensing/touch_overlay.h"

namespace tactics {

/// --lever, --finger, --rate, with the default delay and finger for a real mouse. Throws Error.
MouseSettings machine_of(const Given& given);
/// "600x340mm", "20mm,30mm": two lengths; a unit at the end applies to both.
std::optional<Point> two_lengths(std::string_view text, char between);

/// The kind for a name such as "recorded:hand.csv". Throws Error(usage) for an unknown name.
const DeviceKind& kind_of_device(const std::string& name);

struct OverlayWish {
    std::string name;  ///< "auto", "/dev/input/event0"
    OverlayPlace place;
};
/// --overlay, --overlay-size, --map-at, which require a real mouse. Throws Error(usage).
std::optional<OverlayWish> overlay_of(const Given& given);

/// Opens the device with that name, with the overlay if one is wanted, and reports when the overlay is gone and when it is back.
/// The part after the name goes into the wish. Throws Error.
std::unique_ptr<HapticDevice> open_mouse(const std::string& name, DeviceWish wish, const std::optional<OverlayWish>& overlay);

/// The parameters learned last time, if they were kept. Throws Error if the user named a file with other contents; an invalid
/// file of our own is reported and started anew.
std::optional<LearnedPointing> learned_before(const std::string& file, bool own, bool quiet);
/// Saves them for the next time. If our own file cannot be written, prints a note; throws Error for a file that the user named.
void keep_learned(const std::string& file, bool own, const Fusion& fusion, bool quiet);

}  // namespace tactics
