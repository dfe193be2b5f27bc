// SPDX-License-Identifier: Apache-2.0
// Hands that explore a plot on a simulated arm, from nothing but what a person has: where the finger is, and what pushes it.
//
// They are scripts with a person's limits (all assumed): a force is felt 60 ms late, smoothed over 20 ms, and below 0.1 N not at
// all. What a hand takes to be there is its finding; whether that is true is for others to say.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "tactics/point3.h"

namespace tactics {

/// In the axes of the scene: x to the right, y downwards, z towards the person, mm; N. The force is what the motors give:
/// friction and inertia of an arm are the same everywhere, and a person gets used to them.
struct HandSense {
    Point3 finger;
    Point3 force;
};

/// What a hand took to be at a place.
struct HandFinding {
    std::string_view what;  ///< "curve", "end of the curve", "tick", "point", "height"
    Point3 place;
    double time = 0;  ///< s since it began
};

class Hand {
public:
    virtual ~Hand() = default;
    /// Where it is to be next, `dt` s later. Its findings have room from the start; nothing else allocates.
    virtual Point3 move(const HandSense& sense, double dt) noexcept = 0;
    virtual bool is_done() const noexcept = 0;
    virtual const std::vector<HandFinding>& findings() const noexcept = 0;
    /// That it presses, bit 0 the first: for a moment after it has found something, to be told where it is (the first), what is
    /// under its finger (the third) or what point is near (the fourth); those that it was given.
    virtual unsigned keys() const noexcept = 0;
};

/// The field that it explores.
struct HandField {
    double width = 100, height = 80, depth = 0;  ///< mm; depth: of a surface's heights
    double speed = 40;                           ///< mm/s
    std::vector<unsigned> keys = {};             ///< that a hand that is led presses one after the other, from 1
};

struct HandKind {
    std::string_view name, what;
    bool of_plots = false;  ///< it looks for curves or points, which only a plot has
    std::unique_ptr<Hand> (*make)(const HandField& field);
};
/// trace: goes to where the axes meet, up the left one until a curve pulls, along the curve to its end, down to the lower axis
/// and along that to a tick. points: sweeps the field in rows and takes down where something pushes. sections: presses on a
/// surface along two lines through its middle and takes down heights. to-and-fro: through the middle, from side to side, for
/// ever. led: touches the middle, goes 50 ms behind whatever moves its finger, and presses its next key when that has rested for
/// a second.
const std::vector<HandKind>& hands();

}  // namespace tactics
