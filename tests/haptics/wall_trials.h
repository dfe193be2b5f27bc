// SPDX-License-Identifier: Apache-2.0
// A hand that pushes a haptic mouse over a wall, or stops just before it: what the lever does then. Shared by the tests and the
// table of walls.
#pragma once

#include "tactics/haptics/scenes/wall.h"

namespace tactics {

inline constexpr double kFloor = 8;     // mm
inline constexpr double kWallTop = 48;  // mm; the edge is at x = 0; half of a wall that is some mm wide is before it

struct Crossing {
    double overshoot = 0;  ///< mm of the lever above the top; 0 if it stays below
    double shift = 0;      ///< mm behind the edge, where the lever passes half the height
    double settled = 0;    ///< s after the edge, from when on the lever is within 1 mm of where it rests
};
/// At constant speed (mm/s). `finger` is the real one, settings.finger the one that is reckoned with.
Crossing cross(const WallSettings& settings, const FingerSettings& finger, double speed, double wide = 0);

/// mm that the lever rises above the floor when the hand brakes with 2500 mm/s2 and stops `before` mm before the wall's foot; 0
/// if it stays below.
double false_bump(const WallSettings& settings, const FingerSettings& finger, double speed, double before, double wide = 0);

/// The highest of stops from `nearest` to 2 mm before the edge, every 0.1 mm.
double highest_false_bump(const WallSettings& settings, const FingerSettings& finger, double speed, double nearest,
                          double wide = 0);

/// mm that the lever rises above the floor when the hand comes straight to the wall and turns along it, on a quarter of a circle
/// of that radius (mm) that ends `before` mm from it.
double turning_bump(const WallSettings& settings, const FingerSettings& finger, double speed, double radius, double before);

/// What no method can better, for a wall that is not known before the hand is sure to reach it: the false bump that is left if
/// the lever is pushed with all force from the moment in which it must be for a shift of `late` mm, until the hand begins to
/// brake, and then pulled down with all force at once.
double least_false_bump(const WallSettings& settings, const FingerSettings& finger, double speed, double before, double late);

}  // namespace tactics
