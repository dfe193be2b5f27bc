// SPDX-License-Identifier: Apache-2.0
// Forces that take effect after a delay.
#pragma once

#include <array>
#include <cstddef>

namespace tactics {

inline constexpr double kMostDelay = 0.02;  // s
inline constexpr double kMostRateHz = 20'000;

/// A queue of fixed length: kMostDelay at kMostRateHz, with some room. Nothing allocates.
template <typename Force>
class Delayed {
public:
    /// The queue cannot overflow within the limits of rate and delay; otherwise the oldest is dropped.
    void give(double due, const Force& force) noexcept {
        if (count_ == due_.size()) {
            first_ = (first_ + 1) % due_.size();
            --count_;
        }
        due_[(first_ + count_) % due_.size()] = {due, force};
        ++count_;
    }
    /// The force in effect at that time, which must not go back.
    const Force& at(double time) noexcept {
        while (count_ > 0 && due_[first_].time <= time) {
            force_ = due_[first_].force;
            first_ = (first_ + 1) % due_.size();
            --count_;
        }
        return force_;
    }
    /// When the next force takes effect, or `end` if that is sooner.
    double next(double end) const noexcept { return count_ > 0 && due_[first_].time < end ? due_[first_].time : end; }

private:
    struct Due {
        double time = 0;
        Force force{};
    };
    std::array<Due, 512> due_{};
    std::size_t first_ = 0, count_ = 0;
    Force force_{};
};

}  // namespace tactics
