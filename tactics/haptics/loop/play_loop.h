// SPDX-License-Identifier: Apache-2.0
// A mouse that is played on, tick after tick, until somebody ends it; unplugged and silent mice included.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "tactics/haptics/devices/haptic_device.h"
#include "tactics/haptics/loop/loop.h"
#include "tactics/haptics/loop/play.h"

namespace tactics {

/// What its user should hear: it was unplugged; it is plugged in and cannot be used, and why; it has not said a word for 2 s;
/// after one of these, it says something again.
enum class DeviceNews { gone, refused, silent, back };

struct PlayLoop {
    double rate = 1000;                                  ///< ticks a second
    std::optional<double> seconds;                       ///< how long; nothing: until the way is over, the stop key, or `ended`
    std::function<bool()> ended = [] { return false; };  ///< asked every tick; then the force goes to zero, and the loop ends
    std::function<void(DeviceNews news, const std::string& why)> told = [](DeviceNews, const std::string&) {};
};

struct PlayLoopReport {
    LoopReport loop;
    unsigned gone = 0;  ///< how often it was unplugged
};

/// Nothing is played before the first word of the mouse. One that is unplugged is waited for; its force begins softly again. From
/// one that says nothing for 3 ms the force goes, which takes 2 ms at most (SafetyLimits::most_slew).
PlayLoopReport run_play(const PlayLoop& loop, Clock& clock, HapticDevice& device, Playing& play);

}  // namespace tactics
