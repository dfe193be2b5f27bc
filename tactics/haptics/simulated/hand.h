// SPDX-License-Identifier: Apache-2.0
// Hands that explore a plot on a simulated arm with only a person's information: the finger's position and the force on it.
//
// They are scripts with a person's limits (all assumed): a force is felt 60 ms late, smoothed over 20 ms, and not at all below
// 0.1 N. A hand reports findings; other code judges whether they are true.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "tactics/point3.h"

namespace tactics {

/// In the axes of the scene: x to the right, y downwards, z towards the person, mm; N. The force is that of the motors: friction
/// and inertia of an arm are the same everywhere, and a person gets used to them.
struct HandSense {
    Point3 finger;
    Point3 force;
};

/// A finding of a hand at a place.
struct HandFinding {
    std::string_view what;  ///< "curve", "end of the curve", "closed curve", "tick", "point", "height across", "height down";
                            ///< along sections also "no ground across", "no ground down" and "stuck", where it did not get on
    Point3 place;
    double time = 0;  ///< s since it began
};

class Hand {
public:
    virtual ~Hand() = default;
    /// Its next position, `dt` s later. Memory for its findings is reserved at the start; nothing else allocates.
    virtual Point3 move(const HandSense& sense, double dt) noexcept = 0;
    virtual bool is_done() const noexcept = 0;
    virtual const std::vector<HandFinding>& findings() const noexcept = 0;
    /// The keys that it presses, bit 0 for the first: for a moment after a finding, to hear its position (the first), what is
    /// under the finger (the third) or the nearest point (the fourth); or the given keys.
    virtual unsigned keys() const noexcept = 0;
};

/// The field that it explores.
struct HandField {
    double width = 100, height = 80, depth = 0;  ///< mm; depth: range of a surface's heights
    double speed = 40;                           ///< mm/s
    std::vector<unsigned> keys = {};             ///< keys that a led hand presses in turn, from 1
};

struct HandKind {
    std::string_view name, what;
    bool of_plots = false;  ///< it searches for curves or points, which only a plot has
    bool ends = false;      ///< it comes to an end of its own
    std::unique_ptr<Hand> (*make)(const HandField& field);
};
/// trace: goes to the corner of the axes, up the left axis until a curve pulls, along the curve to its end, down to the lower
/// axis and along that to a tick. points: sweeps the field in rows and notes where something pushes. sections: presses on a
/// surface along two lines through its middle and notes heights. to-and-fro: moves through the middle, from side to side, for
/// ever. led: touches the middle, follows the movement of its finger with a delay of 50 ms, and presses its next key when the
/// finger has rested for a second.
const std::vector<HandKind>& hands();

}  // namespace tactics
