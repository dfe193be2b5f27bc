// SPDX-License-Identifier: Apache-2.0
// The force of a virtual surface on a lever that can only move up and down: the penalty method of the 1-DOF haptic mouse (section
// IV.B, equation 1).
#pragma once

namespace tactics {

/// Equation 1 adds Kd (Zfin - Zfin_before), which drives a finger on in the direction in which it moves unless Kd is negative.
/// The paper says "Kd < 0", but only where the finger rises above the surface; inside the object, where it speaks of an impulse
/// against penetration, Kd is 0.
enum class DampingSign {
    corrected,   ///< against the motion, inside the object
    as_printed,  ///< the plus of equation 1 with a positive constant, inside the object: it removes damping. For demonstration,
                 ///< not for use
};

struct ForceLaw {
    double stiffness = 1;         ///< N/mm; Kp
    double damping_ns_per_m = 1;  ///< Kd times the time of a loop
    DampingSign sign = DampingSign::corrected;
};

/// N, upwards; never negative, because a surface does not pull. Zero if the finger is not below the object, if `dt` is not
/// positive or if any value is NaN. `finger_before` is the height at the previous tick, `dt` seconds ago.
double force(const ForceLaw& law, double object, double finger, double finger_before, double dt) noexcept;

/// The same spring and damper, acting from both sides of `object`: for a reference that moves (wall.h).
double coupling_force(const ForceLaw& law, double object, double finger, double finger_before, double dt) noexcept;

}  // namespace tactics
