// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/sensing/device_clock.h"

#include <algorithm>

namespace tactics {

namespace {

// Two quartzes of 100 ppm each may go apart so fast.
constexpr double kDrift = 2e-4;
// From the first reports, which came late, to the first that came soon: so fast does time go meanwhile, of the device's.
constexpr double kSlowest = 0.5;
// s: a report this far ahead of its own arrival means that the clock has changed.
constexpr double kAhead = 0.5;
// s: so late for so long: it is no waiting queue (64 reports in the kernel), it has another clock.
constexpr double kLate = 0.1, kPatience = 1;
constexpr double kLeastSpan = 1e-6;  // s

}  // namespace

void DeviceClock::begin(double arrival) noexcept {
    known_ = true;
    late_ = false;
    device_ = 0;
    offset_ = arrival;
    last_ = std::max(arrival, last_ + kLeastSpan);
}

double DeviceClock::time(std::uint32_t microseconds, double arrival) noexcept {
    const double passed = 1e-6 * static_cast<double>(static_cast<std::uint32_t>(microseconds - before_));
    before_ = microseconds;
    if (!known_) {
        begin(arrival);
        return last_;
    }
    device_ += passed;
    const double late = arrival - (device_ + offset_);
    if (late < kLate)
        late_ = false;
    else if (!late_) {
        late_ = true;
        late_since_ = arrival;
    }
    if (late < -kAhead || (late_ && arrival - late_since_ > kPatience)) {
        begin(arrival);
        return last_;
    }
    offset_ = std::min(offset_ + kDrift * passed, arrival - device_);
    last_ = std::max(device_ + offset_, last_ + kSlowest * passed);
    return last_;
}

}  // namespace tactics
