// SPDX-License-Identifier: Apache-2.0
// Forces that take effect some time after they are given.
#pragma once

#include <array>
#include <cstddef>

namespace tactics {

inline constexpr double kMostDelay = 0.02;  // s
inline constexpr double kMostRateHz = 20'000;

/// A row of fixed length: kMostDelay at kMostRateHz, and room. Nothing allocates.
template <typename Force>
class Delayed {
public:
    /// More under way than there is room for cannot be within the bounds of rate and delay; the oldest goes.
    void give(double due, const Force& force) noexcept {
        if (count_ == due_.size()) {
            first_ = (first_ + 1) % due_.size();
            --count_;
        }
        due_[(first_ + count_) % due_.size()] = {due, force};
        ++count_;
    }
    /// What is in effect at that time, which does not go back.
    const Force& at(double time) noexcept {
        while (count_ > 0 && due_[first_].time <= time) {
            force_ = due_[first_].force;
            first_ = (first_ + 1) % due_.size();
            --count_;
        }
        return force_;
    }
    /// When the next takes effect, or `end`, if that is sooner.
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
