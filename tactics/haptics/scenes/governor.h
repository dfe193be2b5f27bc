// SPDX-License-Identifier: Apache-2.0
// A height that moves towards another no faster than a motor can lift a lever and the finger on it.
//
// Unlike a filter it knows the force: inside is the lever with a finger (lever.h) without dry friction, delay and encoder, pushed
// by no more than the motor has. Where the motor can follow the target at once, it does.
#pragma once

#include "tactics/haptics/simulated/lever.h"

namespace tactics {

class Governor {
public:
    /// `stiffness` is of the force law (N/mm): at rest the lever hangs below the reference by what weight and preload make of it.
    Governor(const LeverSettings& lever, const FingerSettings& finger, double stiffness);

    void begin(double height) noexcept;
    void follow(double target, double dt) noexcept;  ///< one tick

    double height() const noexcept { return state_.height + hang_; }  ///< of the reference
    double velocity() const noexcept { return state_.velocity; }      ///< mm/s
    double force() const noexcept { return force_; }                  ///< N of the motor for the tick before; within most_force
    bool under_way() const noexcept { return under_way_; }
    /// N to be added to the force law's, which itself holds weight and preload: 0 where no way is under way.
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
