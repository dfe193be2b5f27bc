// SPDX-License-Identifier: Apache-2.0
// An absolute overlay that sees the finger on a haptic mouse, and a mouse with one.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "tactics/haptics/devices/haptic_device.h"
#include "tactics/haptics/sensing/fusion.h"
#include "tactics/transport/touch_device.h"

namespace tactics {

/// s, CLOCK_MONOTONIC.
inline double monotonic_now() noexcept {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class Overlay {
public:
    enum class State { nothing, sample, gone };
    virtual ~Overlay() = default;
    /// The newest sample since the last call. Never waits, never allocates.
    virtual State read(OverlaySample& sample) noexcept = 0;
};

/// How an overlay lies. Maps and overlays both count y downwards.
struct OverlayPlace {
    double width = 0, height = 0;  ///< mm, of the field that it sees; 0: it tells by itself
    Point map_at;                  ///< mm, of the left upper corner of the map from that of the field
};

/// Of several contacts (a palm, the mouse itself) the nearest to where the finger was last is the finger; where it was nowhere,
/// the newest. Throws Error(failed) at `path`: it does not tell how large it is. `now` is the clock of the device's frames.
std::unique_ptr<Overlay> touch_overlay(std::unique_ptr<TouchDevice> device, const OverlayPlace& place, const std::string& path,
                                       double (*now)() noexcept = monotonic_now);

/// The mouse with what an overlay tells in each of its samples. `open` throws Error; the first time that is passed on. An overlay
/// that is gone is opened again when it is back, and `told` (false: gone, true: there again); both are called in a thread of
/// their own, as a tick has no time for them.
std::unique_ptr<HapticDevice> mouse_with_overlay(std::unique_ptr<HapticDevice> mouse,
                                                 std::function<std::unique_ptr<Overlay>()> open,
                                                 std::function<void(bool there)> told);

}  // namespace tactics
