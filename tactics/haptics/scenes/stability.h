// SPDX-License-Identifier: Apache-2.0
// Which stiffness and damping a haptic mouse bears: computed before it is switched on.
//
// A loop that measures and pushes once a millisecond gives energy to what it holds. Whether lever and finger take it away again
// is found by simulation: a small push and a fall onto the surface must both come to rest. The bound by the lever's own damping b
// alone, b > K T / 2 + B (J. E. Colgate, G. Schenkel, "Passivity of a class of sampled-data systems", 1997; from memory), holds
// for every finger, and leaves most of what is stable unused.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tactics/haptics/scenes/force_law.h"
#include "tactics/haptics/simulated/arm.h"
#include "tactics/haptics/simulated/lever.h"

namespace tactics {

/// How much a small deviation grows from one tick to the next while lever and finger stay in contact, without dry friction and
/// encoder: the spectral radius of the sampled system. Above 1 only friction can end a swing. `finger` may be null.
double growth(const ForceLaw& law, const LeverSettings& lever, const FingerSettings* finger);

/// After a small push and after a fall: lever and force, for each of the fingers; the lever alone, if there is none.
bool comes_to_rest(const ForceLaw& law, const LeverSettings& lever, std::span<const FingerSettings> fingers);

/// N/mm, within 2 %: this and all tried below it come to rest. 0 if none does.
double largest_stiffness(double damping_ns_per_m, DampingSign sign, const LeverSettings& lever,
                         std::span<const FingerSettings> fingers);

/// What a machine bears, whoever plays on it: with each of the fingers and with none, as any finger is lifted at some time, and
/// without its dry friction, which ends swings, and which nobody has measured. Its largest stiffness in N/mm, as above.
double borne_stiffness(double damping_ns_per_m, DampingSign sign, const LeverSettings& lever,
                       std::span<const FingerSettings> fingers);

struct StablePoint {
    double damping_ns_per_m = 0;
    double stiffness = 0;  ///< the largest that is borne, N/mm
};
/// The border of what is borne for a chart: `count` dampings from 0 to `most_damping_ns_per_m`.
std::vector<StablePoint> stable_region(double most_damping_ns_per_m, int count, DampingSign sign, const LeverSettings& lever,
                                       std::span<const FingerSettings> fingers);

struct StableCheck {
    bool stable = false;
    std::string reason;  ///< empty if stable
    /// The nearest that is borne with a tenth to spare: as stiff with more damping, or else softer. What was asked for, if that
    /// is borne; 0 if there is none.
    double stiffness = 0;
    double damping_ns_per_m = 0;
};
/// The same of an arm, whose fixtures hold a finger from both sides: a small deviation grows in no direction, with each of the
/// fingers in its thimble and with none, and dry friction is not counted on. And it is no stiffer than the maker of the arm
/// promises.
StableCheck check_arm(const ForceLaw& law, const ArmSettings& arm, std::span<const FingerSettings> fingers);

/// Whether the law is borne.
StableCheck check_stable(const ForceLaw& law, const LeverSettings& lever, std::span<const FingerSettings> fingers);

}  // namespace tactics
