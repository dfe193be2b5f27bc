// SPDX-License-Identifier: Apache-2.0
// A height that moves towards a target no faster than a motor can lift a lever with a finger.
//
// Unlike a filter it knows the force: it simulates the lever with a finger (lever.h) without dry friction, delay and encoder,
// pushed by at most the motor's force. If the motor can follow the target at once, the height does.
#pragma once

#include "tactics/haptics/simulated/lever.h"

namespace tactics {

class Governor {
public:
    /// `stiffness` is that of the force law (N/mm): at rest, weight and preload hold the lever below the reference.
    Governor(const LeverSettings& lever, const FingerSettings& finger, double stiffness);

    void begin(double height) noexcept;
    void follow(double target, double dt) noexcept;  ///< one tick

    double height() const noexcept { return state_.height + hang_; }  ///< of the reference
    double velocity() const noexcept { return state_.velocity; }      ///< mm/s
    double force() const noexcept { return force_; }                  ///< motor force of the previous tick, N; within most_force
    bool under_way() const noexcept { return under_way_; }
    /// N to add to the force law, which itself carries weight and preload: 0 while there is no motion.
    double lead() const noexcept { return under_way_ ? force_ - at_rest_ : 0; }
    double hang() const noexcept { return hang_; }

private:
    double force_towards(double target, double dt) const noexcept;

    LeverSettings lever_;
    FingerSettings finger_;
    double at_rest_ = 0;  ///< N: weight and preload
    double hang_ = 0;
    double force_ = 0;
    LeverState state_;
    bool under_way_ = false;
};

}  // namespace tactics
