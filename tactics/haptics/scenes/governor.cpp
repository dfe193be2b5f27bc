// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/governor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tactics {

namespace {

constexpr double kMmPerM = 1000;  // and g per kg
constexpr double kStep = 250e-6;  // s
constexpr double kBraked = 0.6;   // of the deceleration, in planning where to begin it: the rest corrects
constexpr double kWayOver = 20;   // mm/s: slower than this, and at the target, a way is over
constexpr double kClose = 4;      // ticks to the target at the end of the way

double mm_per_s2(double force, double mass_g) { return force / mass_g * kMmPerM * kMmPerM; }

// The law's own terms: nothing that a motor must not reckon with.
LeverSettings ideal(LeverSettings lever) {
    lever.friction = 0;
    lever.lowest = -std::numeric_limits<double>::infinity();  // a lever at its stop rests; the reference need not
    lever.highest = -lever.lowest;
    return lever;
}

}  // namespace

Governor::Governor(const LeverSettings& lever, const FingerSettings& finger, double stiffness)
    : lever_(ideal(lever)),
      finger_(finger),
      at_rest_(lever.mass_g / kMmPerM * lever.gravity_m_per_s2 + finger.preload),
      hang_(stiffness > 0 ? at_rest_ / stiffness : 0) {}

void Governor::begin(double height) noexcept {
    state_ = at_rest(finger_, height - hang_);
    force_ = at_rest_;
    under_way_ = false;
}

// As fast as it can be braked again; the force that brings the lever to that velocity within a tick, as far as the motor has it.
double Governor::force_towards(double target, double dt) const noexcept {
    const double left = target - height();
    // Up to the target, the motor's pull and the finger brake; down to it, the motor's push.
    const double brakes = left > 0 ? lever_.most_force + at_rest_ : lever_.most_force - at_rest_;
    const double brake = kBraked * mm_per_s2(std::max(brakes, 0.1), lever_.mass_g + finger_.mass_g);
    const double wanted = std::copysign(std::min(std::sqrt(2 * brake * std::abs(left)), std::abs(left) / (kClose * dt)), left);
    const double opposed = lever_.mass_g / kMmPerM * lever_.gravity_m_per_s2 + lever_.damping_ns_per_m / kMmPerM * velocity() +
                           pad_force(state_, finger_);
    const double force = (wanted - velocity()) / dt / mm_per_s2(1, lever_.mass_g) + opposed;
    // It pulls to end a rise, but never to make a finger fall faster than it does by itself.
    return std::clamp(force, velocity() > 0 ? -lever_.most_force : 0.0, lever_.most_force);
}

void Governor::follow(double target, double dt) noexcept {
    if (!(dt > 0) || !std::isfinite(target)) return;
    if (!under_way_) {
        const double wanted = (target - height()) / dt;
        const double held = finger_.stiffness * (state_.finger - state_.rest) - finger_.preload +
                            (lever_.damping_ns_per_m + finger_.damping_ns_per_m) / kMmPerM * wanted;
        const double force = at_rest_ + held + (wanted - velocity()) / dt / mm_per_s2(1, lever_.mass_g + finger_.mass_g);
        if (force >= 0 && force <= lever_.most_force) {
            force_ = force;
            state_.velocity = state_.finger_velocity = wanted;
            state_.height = target - hang_;
            state_.finger = state_.height - finger_.preload / finger_.pad_stiffness;
            state_.rest +=
                (state_.finger - finger_.preload / finger_.stiffness - state_.rest) * std::min(1.0, dt / finger_.relaxation);
            return;
        }
    }
    under_way_ = true;
    force_ = force_towards(target, dt);
    const int steps = static_cast<int>(std::clamp(std::ceil(dt / kStep), 1.0, 100.0));
    for (int i = 0; i < steps; ++i) move(state_, lever_, &finger_, force_, dt / steps);
    if (std::abs(target - height()) < kWayOver * dt && std::abs(velocity()) < kWayOver) under_way_ = false;
}

}  // namespace tactics
