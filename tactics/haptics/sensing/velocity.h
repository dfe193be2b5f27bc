// SPDX-License-Identifier: Apache-2.0
// How fast a finger moves, from its places alone.
#pragma once

#include <array>
#include <cstddef>

#include "tactics/drawing.h"

namespace tactics {

/// The mean velocity over as many of the last ticks as lie on one straight course: F. Janabi-Sharifi, V. Hayward and C.-S. J.
/// Chen, "Discrete-time adaptive windowing for velocity estimation", IEEE Transactions on Control Systems Technology 8(6), 2000
/// (the end-fit form). Even motion is averaged over many ticks, so that counts in lumps do no harm, and a hand that begins to
/// brake is known within a tick or two where places are exact. How far places may lie off a course is learned from themselves:
/// three times what the second differences of those before it were on average, which lumps of counts make large and a hand's
/// acceleration does not.
///
/// Nothing allocates; at most kMost places are looked at in a tick.
class AdaptiveVelocity {
public:
    void step(Point moved, double dt) noexcept;            ///< mm, s; what cannot be is passed over
    Point velocity() const noexcept { return velocity_; }  ///< mm/s
    double doubt() const noexcept { return doubt_; }  ///< mm/s that it may be wrong by: what a place may lie off, over the course
    void begin_again() noexcept { *this = {}; }

    static constexpr std::size_t kMost = 16;  ///< ticks that a course may be long

private:
    struct Moment {
        double time = 0;
        Point at;
        double uneven = 0;  ///< mm, its second difference
    };
    const Moment& past(std::size_t ago) const noexcept { return moments_[(last_ + moments_.size() - ago) % moments_.size()]; }
    bool is_straight(std::size_t ticks) const noexcept;

    std::array<Moment, kMost + 1> moments_{};
    std::size_t last_ = 0, count_ = 1;
    double uneven_ = 0;  ///< mm, the mean second difference of places that no course holds any more
    Point velocity_;
    double doubt_ = 0;
};

}  // namespace tactics
