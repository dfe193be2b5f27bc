// SPDX-License-Identifier: Apache-2.0
// The velocity of a finger, from its positions alone.
#pragma once

#include <array>
#include <cstddef>

#include "tactics/drawing.h"

namespace tactics {

/// The mean velocity over as many of the last ticks as lie on one straight line: F. Janabi-Sharifi, V. Hayward and C.-S. J. Chen,
/// "Discrete-time adaptive windowing for velocity estimation", IEEE Transactions on Control Systems Technology 8(6), 2000 (the
/// end-fit form). Steady motion is averaged over many ticks, so that lumps of counts do no harm; a hand that begins to brake is
/// detected within a tick or two if positions are exact. The tolerance of the line is learned from the data: three times the
/// average second difference of earlier positions, which lumps of counts make large and a hand's acceleration does not.
///
/// Nothing allocates; a tick examines at most kMost positions.
class AdaptiveVelocity {
public:
    void step(Point moved, double dt) noexcept;            ///< mm, s; ignores impossible values
    Point velocity() const noexcept { return velocity_; }  ///< mm/s
    double doubt() const noexcept {
        return doubt_;
    }  ///< possible error, mm/s: the tolerance of a position over the duration of
       ///< the line
    void begin_again() noexcept { *this = {}; }

    static constexpr std::size_t kMost = 16;  ///< longest line, in ticks

private:
    struct Moment {
        double time = 0;
        Point at;
        double uneven = 0;  ///< its second difference, mm
    };
    const Moment& past(std::size_t ago) const noexcept { return moments_[(last_ + moments_.size() - ago) % moments_.size()]; }
    bool is_straight(std::size_t ticks) const noexcept;

    std::array<Moment, kMost + 1> moments_{};
    std::size_t last_ = 0, count_ = 1;
    double uneven_ = 0;  ///< mm, mean second difference of positions older than the current line
    Point velocity_;
    double doubt_ = 0;
};

}  // namespace tactics
