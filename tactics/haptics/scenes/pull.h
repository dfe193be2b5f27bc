// SPDX-License-Identifier: Apache-2.0
// The force that pulls a finger to the place where it would be without entering a surface.
#pragma once

#include <algorithm>

#include "tactics/haptics/scenes/force_law.h"
#include "tactics/haptics/scenes/scene.h"

namespace tactics {

/// N: the spring from the finger to `outside`, minus the damper along it, which never pulls the finger in. 0 if it is there
/// already. There is no friction, so there is no force along the surface.
inline Point3 pull(const ForceLaw& law, const Point3& outside, const Touch& touch) noexcept {
    const Point3 way = outside - touch.finger;
    const double deep = length_of(way);
    if (!(deep > 0)) return {};
    constexpr double kPerMetre = 1000;  // mm/s
    const Point3 unit = (1 / deep) * way;
    const double damped = law.damping_ns_per_m * dot(touch.velocity, unit) / kPerMetre;
    const double force = law.stiffness * deep - (std::isfinite(damped) ? damped : 0);
    return std::max(force, 0.0) * unit;
}

}  // namespace tactics
