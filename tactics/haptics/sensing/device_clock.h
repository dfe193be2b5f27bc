// SPDX-License-Identifier: Apache-2.0
// The clock of a device, told by what it sends, on the clock of this computer.
#pragma once

#include <cstdint>

namespace tactics {

/// What a device sends comes some time after it has happened, never before: the least of (arrival - its clock) that was seen is
/// nearest to how far the two clocks are apart, and the jitter of arrivals is gone. Time never goes back, and stands still only
/// if the device's does.
class DeviceClock {
public:
    /// s, by the clock of `arrival`: when the device's clock (us, mod 2^32) was at that.
    double time(std::uint32_t microseconds, double arrival) noexcept;
    /// It is another device, or the same one switched on again.
    void restart() noexcept { known_ = false; }

private:
    void begin(double arrival) noexcept;

    bool known_ = false;
    std::uint32_t before_ = 0;
    double device_ = 0;      // s, by its clock since it is known, run over or not
    double offset_ = 0;      // s, from that to ours
    double last_ = -1e12;    // s, what was told
    double late_since_ = 0;  // s, the first arrival of those that are all much too late
    bool late_ = false;
};

}  // namespace tactics
