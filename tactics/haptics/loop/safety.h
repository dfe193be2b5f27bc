// SPDX-License-Identifier: Apache-2.0
// The safety between a scene and a motor: no requested force can hurt a finger.
#pragma once

#include "tactics/point3.h"

namespace tactics {

struct SafetyLimits {
    double most_force = 8;    ///< N, in any direction; the paper's mouse has no more (1-DOF haptic mouse, section IV.A)
    double most_slew = 4000;  ///< N/s: from zero to full force in 2 ms
    double soft_start = 0.3;  ///< s until the full force is reached
    double most_dt = 0.005;   ///< s; after a later tick, or a longer fault, the force begins softly again
};

/// Non-finite forces become zero; then come the soft start, the slew limit and the clamp, each by the length of the force in
/// space, so that its direction is kept; a mouse has only a z. The result is always finite, within the limits (up to rounding,
/// and exactly along an axis), and no further from the last than the slew allows. Nothing here throws or allocates.
class Safety {
public:
    explicit Safety(const SafetyLimits& limits) : limits_(limits) {}

    /// The force to apply, `dt` seconds (measured) after the last.
    Point3 pass(const Point3& wished, double dt) noexcept;
    /// The soft start begins anew.
    void begin_softly() noexcept { started_ = 0; }
    /// The same, if the motor is off already.
    void let_go() noexcept { started_ = 0, last_ = {}; }
    /// From now on the force goes to zero, as fast as the slew allows, and stays there.
    void stop() noexcept { stopped_ = true; }
    bool stopped() const noexcept { return stopped_; }
    /// How often it intervened: non-finite forces, late ticks.
    unsigned not_finite() const noexcept { return not_finite_; }
    unsigned too_late() const noexcept { return too_late_; }

private:
    SafetyLimits limits_;
    Point3 last_;
    double started_ = 0;
    bool stopped_ = false;
    unsigned not_finite_ = 0, too_late_ = 0;
};

}  // namespace tactics
