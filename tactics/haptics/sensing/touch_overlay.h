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
    /// The newest sample since the last call. Does not wait or allocate.
    virtual State read(OverlaySample& sample) noexcept = 0;
};

/// The placement of an overlay. For both maps and overlays, y points downwards.
struct OverlayPlace {
    double width = 0, height = 0;  ///< mm, of the field that it sees; 0: it reports its size
    Point map_at;                  ///< mm, upper left corner of the map from that of the field
};

/// Of several contacts (a palm, the mouse itself), the nearest to the finger's last place is the finger; without a last place,
/// the newest. Throws Error(failed) at `path` if the overlay does not report its size. `now` is the clock of the device's frames.
std::unique_ptr<Overlay> touch_overlay(std::unique_ptr<TouchDevice> device, const OverlayPlace& place, const std::string& path,
                                       double (*now)() noexcept = monotonic_now);

/// The mouse, with the overlay's data in each of its samples. `open` throws Error, which is passed on the first time. A lost
/// overlay is opened again when it is back, and `told` is called (false: gone, true: back); both run in a separate thread,
/// because a tick has no time for them.
std::unique_ptr<HapticDevice> mouse_with_overlay(std::unique_ptr<HapticDevice> mouse,
                                                 std::function<std::unique_ptr<Overlay>()> open,
                                                 std::function<void(bool there)> told);

}  // namespace tactics
