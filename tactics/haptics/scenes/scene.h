// SPDX-License-Identifier: Apache-2.0
// What is felt at a place: the one thing that a haptic loop plays, whatever it shows.
//
// A scene answers where a finger is with the force on it. It knows nothing of devices, clocks and limits: the loop owns time and
// safety (loop/safety.h), whatever a scene answers.
#pragma once

#include "tactics/drawing.h"
#include "tactics/point3.h"

namespace tactics {

/// A finger, as its device tells of it.
struct Touch {
    Point3 finger;      ///< mm
    Point3 velocity;    ///< mm/s
    double doubt = 0;   ///< mm/s that the velocity over the map may be wrong by
    unsigned keys = 0;  ///< that are down: bit 0 the first
};

/// A scene's answer.
struct Felt {
    Point3 force;          ///< N on the finger; a device with fewer directions gives those that it has
    double surface = 0;    ///< mm, of what is under the finger
    double reference = 0;  ///< mm, where the force leads it
};

/// One finger's meeting with a scene: what changes while it feels (how fast it was, which edge it has just passed) is in here,
/// what is felt stays as it was.
class Scene {
public:
    virtual ~Scene() = default;
    /// Once a tick, `dt` seconds after the last; 0 where that is not known. Does not allocate, throw or wait. Whatever is told,
    /// it answers; what is not finite is caught by the loop's safety.
    virtual Felt feel(const Touch& touch, double dt) noexcept = 0;
    /// The finger was away, and where it was is no longer to be reckoned with.
    virtual void begin_again() noexcept = 0;
};

}  // namespace tactics
