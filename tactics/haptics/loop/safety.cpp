// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/loop/safety.h"

#include <algorithm>
#include <cmath>

namespace tactics {

Point3 Safety::pass(const Point3& asked, double dt) noexcept {
    Point3 wished = asked;
    if (!is_finite(wished)) {
        wished = {};
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
    const Point3 goal = stopped_ ? Point3{} : within(wished, limits_.most_force * share), way = goal - last_;
    const double step = limits_.most_slew * dt;
    last_ = length_of(way) > step ? within(last_ + within(way, step), limits_.most_force) : goal;
    return last_;
}

}  // namespace tactics
