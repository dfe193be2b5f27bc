// SPDX-License-Identifier: Apache-2.0
// Converts a device's clock, as sent in its reports, to the clock of this computer.
#pragma once

#include <cstdint>

namespace tactics {

/// Reports arrive some time after the event, never before: the smallest observed (arrival - device clock) is closest to the
/// offset of the two clocks, and removes the jitter of arrivals. Time never goes back, and stands still only if the device's
/// does.
class DeviceClock {
public:
    /// The time, s, by the clock of `arrival`, at which the device's clock (us, mod 2^32) had this value.
    double time(std::uint32_t microseconds, double arrival) noexcept;
    /// Call it for another device, or the same one after it was switched on again.
    void restart() noexcept { known_ = false; }

private:
    void begin(double arrival) noexcept;

    bool known_ = false;
    std::uint32_t before_ = 0;
    double device_ = 0;      // s, by its clock since the first report, overflows included
    double offset_ = 0;      // s, offset from that to ours
    double last_ = -1e12;    // s, last result
    double late_since_ = 0;  // s, first arrival of a series that is consistently much too late
    bool late_ = false;
};

}  // namespace tactics
