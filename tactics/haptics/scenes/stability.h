// SPDX-License-Identifier: Apache-2.0
// The stiffness and damping at which a haptic mouse is stable, computed before it is switched on.
//
// A loop that measures and pushes once per millisecond adds energy. A simulation shows whether lever and finger dissipate it:
// after a small push and after a fall onto the surface, both must come to rest. The bound by the lever's own damping b alone, b >
// K T / 2 + B (J. E. Colgate, G. Schenkel, "Passivity of a class of sampled-data systems", 1997; from memory), holds for every
// finger, but excludes most stable settings.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tactics/haptics/scenes/force_law.h"
#include "tactics/haptics/simulated/arm.h"
#include "tactics/haptics/simulated/lever.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// The growth of a small deviation from one tick to the next while lever and finger stay in contact, without dry friction and
/// encoder: the spectral radius of the sampled system. Above 1, only friction can end a swing. `finger` may be null.
double growth(const ForceLaw& law, const LeverSettings& lever, const FingerSettings* finger);

/// Whether lever and force come to rest after a small push and after a fall, for each of the fingers; for the lever alone, if
/// there is none.
bool comes_to_rest(const ForceLaw& law, const LeverSettings& lever, std::span<const FingerSettings> fingers);

/// N/mm, within 2 %: this stiffness and all lower ones tried come to rest. 0 if none does.
double largest_stiffness(double damping_ns_per_m, DampingSign sign, const LeverSettings& lever,
                         std::span<const FingerSettings> fingers);

/// The stability of a machine for any user: with each finger and with none, because any finger may be lifted, and without its dry
/// friction, which ends swings but has not been measured. Its largest stiffness in N/mm, as above.
double borne_stiffness(double damping_ns_per_m, DampingSign sign, const LeverSettings& lever,
                       std::span<const FingerSettings> fingers);

struct StablePoint {
    double damping_ns_per_m = 0;
    double stiffness = 0;  ///< the largest stable stiffness, N/mm
};
/// The border of stability for a chart: `count` dampings from 0 to `most_damping_ns_per_m`.
std::vector<StablePoint> stable_region(double most_damping_ns_per_m, int count, DampingSign sign, const LeverSettings& lever,
                                       std::span<const FingerSettings> fingers);

struct StableCheck {
    bool stable = false;
    Phrase reason;  ///< empty if stable
    /// The nearest stable setting with a tenth to spare: equally stiff with more damping, or else softer. The requested setting,
    /// if it is stable; 0 if there is none.
    double stiffness = 0;
    double damping_ns_per_m = 0;
};
/// The same for an arm, whose fixtures hold a finger from both sides: a small deviation must not grow in any direction, with each
/// finger in its thimble and with none, without relying on dry friction. It must also be no stiffer than the maker of the arm
/// states.
StableCheck check_arm(const ForceLaw& law, const ArmSettings& arm, std::span<const FingerSettings> fingers);

/// Whether the law is stable.
StableCheck check_stable(const ForceLaw& law, const LeverSettings& lever, std::span<const FingerSettings> fingers);

}  // namespace tactics
