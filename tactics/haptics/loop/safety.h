// SPDX-License-Identifier: Apache-2.0
// What stands between a scene and a motor: whatever force is wished for, a finger is not hurt by it.
#pragma once

#include "tactics/point3.h"

namespace tactics {

struct SafetyLimits {
    double most_force = 8;    ///< N, whichever way; the paper's mouse has no more (1-DOF haptic mouse, section IV.A)
    double most_slew = 4000;  ///< N/s: from none to all in 2 ms
    double soft_start = 0.3;  ///< s until all of the force is given
    double most_dt = 0.005;   ///< s; behind a tick that is later than that, or a longer fault, it begins softly again
};

/// First what is not finite becomes none, then the soft start, then the slew, then the clamp, each by the length of the force in
/// space, so that its direction is kept; a mouse has only a z. The answer is always finite, within the limits (to rounding, and
/// exactly along an axis), and no further from the last than the slew allows. Nothing here throws or allocates.
class Safety {
public:
    explicit Safety(const SafetyLimits& limits) : limits_(limits) {}

    /// The force to give, `dt` seconds (measured) after the last.
    Point3 pass(const Point3& wished, double dt) noexcept;
    /// The soft start begins anew.
    void begin_softly() noexcept { started_ = 0; }
    /// So it does, and the motor is off already.
    void let_go() noexcept { started_ = 0, last_ = {}; }
    /// From now on the force goes to zero, within the time that the slew needs; for good.
    void stop() noexcept { stopped_ = true; }
    bool stopped() const noexcept { return stopped_; }
    /// How often something had to be held back: not finite, too late.
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
