// SPDX-License-Identifier: Apache-2.0
// Plays on a mouse, tick after tick, until it is ended; handles unplugged and silent mice.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "tactics/haptics/devices/haptic_device.h"
#include "tactics/haptics/loop/loop.h"
#include "tactics/haptics/loop/play.h"

namespace tactics {

/// Events for the user: it was unplugged; it is plugged in but cannot be used, and why; it was silent for 2 s; it reports again
/// after one of these.
enum class DeviceNews { gone, refused, silent, back };

struct PlayLoop {
    double rate = 1000;                                  ///< ticks a second
    std::optional<double> seconds;                       ///< how long; nothing: until the path ends, the stop key, or `ended`
    std::function<bool()> ended = [] { return false; };  ///< called every tick; if true, the force goes to zero and the loop ends
    std::function<void(DeviceNews news, const std::string& why)> told = [](DeviceNews, const std::string&) {};
};

struct PlayLoopReport {
    LoopReport loop;
    unsigned gone = 0;  ///< number of times it was unplugged
};

/// Nothing is played before the first report of the mouse. The loop waits for an unplugged mouse; its force then begins softly
/// again. If a mouse is silent for 3 ms, its force goes to zero within 2 ms at most (SafetyLimits::most_slew).
PlayLoopReport run_play(const PlayLoop& loop, Clock& clock, HapticDevice& device, Playing& play);

}  // namespace tactics
