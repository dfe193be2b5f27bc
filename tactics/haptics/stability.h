// Which stiffness and damping a haptic mouse bears: computed before it is switched on.
//
// A loop that measures and pushes once a millisecond gives energy to what it holds. Whether lever and finger take it away again is found by simulation:
// a small push and a fall onto the surface must both come to rest.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tactics/haptics/force_law.h"
#include "tactics/haptics/lever.h"

namespace tactics {

inline constexpr double kLimitCycle = 0.09;  // mm from top to bottom that still counts as rest

/// `fingers` may be empty: the lever alone. All of them must come to rest.
bool comes_to_rest(const ForceLaw& law, const LeverSettings& lever, std::span<const FingerSettings> fingers);

/// N/mm, within 2 %: all below it come to rest. 0 if none does.
double largest_stiffness(double damping_ns_per_m, DampingSign sign, const LeverSettings& lever, std::span<const FingerSettings> fingers);

struct StableCheck {
    bool stable = false;
    std::string reason;            ///< empty if stable
    double stiffness = 0;          ///< the nearest stable setting
    double damping_ns_per_m = 0;
};
StableCheck check_stable(const ForceLaw& law, const LeverSettings& lever, std::span<const FingerSettings> fingers);

}  // namespace tactics
