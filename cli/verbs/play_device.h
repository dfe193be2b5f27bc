// SPDX-License-Identifier: Apache-2.0
// The mouse and the machine that play is asked for.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "cli/command.h"
#include "tactics/haptics/devices/device_kind.h"
#include "tactics/haptics/sensing/touch_overlay.h"

namespace tactics {

/// --lever, --finger, --rate, with the delay and the finger that are taken for a real mouse where nothing tells them. Throws
/// Error.
MouseSettings machine_of(const Given& given);
/// "600x340mm", "20mm,30mm": two lengths; a unit at the end is that of both.
std::optional<Point> two_lengths(std::string_view text, char between);

/// Of a name such as "recorded:hand.csv". Throws Error(usage): there is no such.
const DeviceKind& kind_of_device(const std::string& name);

struct OverlayWish {
    std::string name;  ///< "auto", "/dev/input/event0"
    OverlayPlace place;
};
/// --overlay, --overlay-size, --map-at, which go with a real mouse. Throws Error(usage).
std::optional<OverlayWish> overlay_of(const Given& given);

/// Of that name, with the overlay, if one is wanted; says when that is gone and when it is there again. What stands behind the
/// name is put into the wish. Throws Error.
std::unique_ptr<HapticDevice> open_mouse(const std::string& name, DeviceWish wish, const std::optional<OverlayWish>& overlay);

/// What was learned of the mouse last time, if that is kept. Throws Error where the user has named a file of something else; a
/// file of our own is told, and begun anew.
std::optional<LearnedPointing> learned_before(const std::string& file, bool own, bool quiet);
/// For the next time. Where our own file cannot be written that is told; throws Error for one that the user has named.
void keep_learned(const std::string& file, bool own, const Fusion& fusion, bool quiet);

}  // namespace tactics
