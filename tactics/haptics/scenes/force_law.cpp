// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/force_law.h"

#include <algorithm>
#include <cmath>

namespace tactics {

double coupling_force(const ForceLaw& law, double object, double finger, double finger_before, double dt) noexcept {
    if (!(dt > 0)) return 0;
    const double resistance = law.damping_ns_per_m / 1000 * (finger - finger_before) / dt;
    const double sum = law.stiffness * (object - finger) + (law.sign == DampingSign::corrected ? -resistance : resistance);
    return std::isfinite(sum) ? sum : 0;
}

double force(const ForceLaw& law, double object, double finger, double finger_before, double dt) noexcept {
    if (!(object > finger)) return 0;
    return std::max(0.0, coupling_force(law, object, finger, finger_before, dt));
}

}  // namespace tactics
