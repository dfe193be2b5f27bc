// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/loop/safety.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

// The same way, and no longer than `most`.
Point3 within(const Point3& force, double most) noexcept {
    const double length = std::hypot(force.x, force.y, force.z);
    return length > most ? Point3{force.x / length * most, force.y / length * most, force.z / length * most} : force;
}

}  // namespace

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
