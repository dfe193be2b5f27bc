// SPDX-License-Identifier: Apache-2.0
// The interface of everything that a haptic loop plays: the force at a position.
//
// A scene returns the force on a finger at a position. It knows nothing about devices, clocks and limits: the loop is responsible
// for time and safety (loop/safety.h), whatever a scene returns.
#pragma once

#include "tactics/drawing.h"
#include "tactics/point3.h"

namespace tactics {

/// A finger, as reported by its device.
struct Touch {
    Point3 finger;      ///< mm
    Point3 velocity;    ///< mm/s
    double doubt = 0;   ///< possible error of the velocity over the map, mm/s
    unsigned keys = 0;  ///< keys that are down: bit 0 is the first
};

/// A scene's answer.
struct Felt {
    Point3 force;          ///< N on the finger; a device with fewer directions applies those that it has
    double surface = 0;    ///< height of the surface under the finger, mm
    double reference = 0;  ///< height to which the force leads it, mm
};

/// One finger's contact with a scene. It holds the changing state (its speed, the edge it has just passed), not the thing that is
/// felt.
class Scene {
public:
    virtual ~Scene() = default;
    /// Called once per tick, `dt` seconds after the last; 0 if unknown. Does not allocate, throw or wait. It answers any input;
    /// the loop's safety catches non-finite forces.
    virtual Felt feel(const Touch& touch, double dt) noexcept = 0;
    /// The finger was away: forget its previous position.
    virtual void begin_again() noexcept = 0;
};

}  // namespace tactics
