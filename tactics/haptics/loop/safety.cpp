// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/loop/safety.h"

#include <algorithm>
#include <cmath>

namespace tactics {

double Safety::pass(double wished, double dt) noexcept {
    if (!std::isfinite(wished)) {
        wished = 0;
        ++not_finite_;
    }
    if (!std::isfinite(dt) || dt < 0) dt = 0;
    if (dt > limits_.most_dt) {
        // Who knows where the finger is by now.
        ++too_late_;
        started_ = 0;
        dt = limits_.most_dt;
    }
    started_ = std::min(limits_.soft_start, started_ + dt);
    const double share = limits_.soft_start > 0 ? started_ / limits_.soft_start : 1;
    const double most = limits_.most_force * share;
    const double goal = stopped_ ? 0 : std::clamp(wished, -most, most);
    const double step = limits_.most_slew * dt;
    last_ = std::clamp(goal, last_ - step, last_ + step);
    last_ = std::clamp(last_, -limits_.most_force, limits_.most_force);
    return last_;
}

}  // namespace tactics
