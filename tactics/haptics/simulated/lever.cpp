// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/simulated/lever.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

constexpr double kStep = 50e-6;  // s; the stiffest pair, finger on pad, swings at about 80 Hz: 250 steps a swing
constexpr double kMmPerM = 1000;
constexpr double kGPerKg = 1000;

double kg(double g) { return g / kGPerKg; }
double per_mm(double ns_per_m) { return ns_per_m / kMmPerM; }

}  // namespace

LeverState at_rest(const FingerSettings& finger, double height) noexcept {
    const double pad = height - finger.preload / finger.pad_stiffness;
    return {height, 0, pad, 0, pad - finger.preload / finger.stiffness};
}

double pad_force(const LeverState& state, const FingerSettings& finger) noexcept {
    const double pressed = state.height - state.finger;
    if (pressed <= 0) return 0;
    return std::max(
        0.0, finger.pad_stiffness * pressed + per_mm(finger.pad_damping_ns_per_m) * (state.velocity - state.finger_velocity));
}

// Velocities first, heights from the new velocities: keeps the energy of springs bounded.
void move(LeverState& state, const LeverSettings& lever, const FingerSettings* finger, double force, double dt) noexcept {
    const double pad = finger != nullptr ? pad_force(state, *finger) : 0;
    const double mass = kg(lever.mass_g);
    const double pull = force - pad - mass * lever.gravity_m_per_s2 - per_mm(lever.damping_ns_per_m) * state.velocity;
    state.velocity += pull / mass * kMmPerM * dt;
    // Dry friction takes velocity away, and holds what it can stop.
    const double lost = lever.friction / mass * kMmPerM * dt;
    state.velocity = std::abs(state.velocity) <= lost ? 0 : state.velocity - std::copysign(lost, state.velocity);
    state.height += state.velocity * dt;
    if (state.height < lever.lowest || state.height > lever.highest) {
        state.height = std::clamp(state.height, lever.lowest, lever.highest);
        state.velocity = 0;
    }
    if (finger == nullptr) return;
    const double hand =
        finger->stiffness * (state.finger - state.rest) + per_mm(finger->damping_ns_per_m) * state.finger_velocity;
    state.finger_velocity += (pad - hand) / kg(finger->mass_g) * kMmPerM * dt;
    state.finger += state.finger_velocity * dt;
    state.rest += (state.finger - finger->preload / finger->stiffness - state.rest) * dt / finger->relaxation;
}

SimulatedLever::SimulatedLever(const LeverSettings& lever, const std::optional<FingerSettings>& finger, double height)
    : lever_(lever), finger_(finger), state_(finger ? at_rest(*finger, height) : LeverState{height}) {}

void SimulatedLever::push(double force) noexcept {
    const double bounded = std::isfinite(force) ? std::clamp(force, -lever_.most_force, lever_.most_force) : 0.0;
    forces_.give(time_ + std::clamp(lever_.delay, 0.0, kMostDelay), bounded);
}

void SimulatedLever::advance(double seconds) noexcept {
    constexpr double kNow = 1e-9;  // s; sums of ticks are not exact
    const double end = time_ + std::max(0.0, seconds);
    while (end - time_ > kNow) {
        const double force = forces_.at(time_ + kNow);
        const double step = std::min(end, time_ + kStep), until = std::min(step, std::max(forces_.next(step), time_ + 2 * kNow));
        move(state_, lever_, finger_ ? &*finger_ : nullptr, force, until - time_);
        time_ = until;
    }
}

double SimulatedLever::height() const noexcept {
    return lever_.encoder_step > 0 ? std::floor(state_.height / lever_.encoder_step + 0.5) * lever_.encoder_step : state_.height;
}

double SimulatedLever::energy() const noexcept {
    const double mass = kg(lever_.mass_g);
    double sum = 0.5 * mass * state_.velocity * state_.velocity / kMmPerM + mass * lever_.gravity_m_per_s2 * state_.height;
    if (finger_) {
        const double pressed = std::max(0.0, state_.height - state_.finger);
        const double stretched = state_.finger - state_.rest;
        sum += 0.5 * kg(finger_->mass_g) * state_.finger_velocity * state_.finger_velocity / kMmPerM +
               0.5 * finger_->pad_stiffness * pressed * pressed + 0.5 * finger_->stiffness * stretched * stretched;
    }
    return sum;
}

}  // namespace tactics
