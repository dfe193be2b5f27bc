// SPDX-License-Identifier: Apache-2.0
// A simulated haptic mouse with a finger on it: one lever that moves up and down under the fingertip, as in "1 DOF Tabletop
// Haptic Mouse for Shape Recognition of 3D Virtual Objects" (section IV.A: 60 mm of travel, at most 8 N).
//
// The paper gives neither masses nor a finger, so these are assumptions, stated here and changeable by a file (lever_file.h).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "tactics/haptics/simulated/delayed.h"

namespace tactics {

/// The machine. Lengths in mm, forces in N, times in s.
struct LeverSettings {
    double mass_g = 30;             ///< effective at the fingertip: lever, gears, rotor; assumed
    double damping_ns_per_m = 0.3;  ///< assumed
    double friction = 0.05;         ///< Coulomb; assumed
    double gravity_m_per_s2 = 9.81;
    double lowest = 0;             ///< stops
    double highest = 60;           ///< section IV.A: "about 60 mm"
    double encoder_step = 0.0146;  ///< height between two counts; 0 is an ideal encoder
    double most_force = 8;         ///< section IV.A
    double rate_hz = 1000;         ///< rate at which the force is set; it holds until the next
    double delay = 0;              ///< from setting a force to its effect, besides the hold; at most kMostDelay
    bool operator==(const LeverSettings&) const = default;
};

/// The finger on it: a mass on a spring and a damper, whose far end follows so that it presses with `preload` again after a
/// while, and a pad between bone and lever that pushes but does not pull. All values are assumed.
struct FingerSettings {
    double mass_g = 8;
    double stiffness = 0.3;  ///< N/mm
    double damping_ns_per_m = 2;
    double pad_stiffness = 1;  ///< N/mm
    double pad_damping_ns_per_m = 2;
    double preload = 1;        ///< N with which the hand presses at rest
    double relaxation = 0.08;  ///< s
    bool operator==(const FingerSettings&) const = default;
};

struct NamedFinger {
    std::string_view name;
    FingerSettings finger;
};
struct NamedLever {
    std::string_view name;
    LeverSettings lever;
};
inline constexpr std::array<NamedFinger, 3> kFingers = {
    {{"soft", {5, 0.1, 1}}, {"nominal", {8, 0.3, 2}}, {"stiff", {10, 0.5, 5}}}};
inline constexpr std::array<NamedLever, 2> kLevers = {{{"light", {30}}, {"heavy", {100}}}};

/// Positions and velocities of both; mm and mm/s.
struct LeverState {
    double height = 0, velocity = 0;
    double finger = 0, finger_velocity = 0;  ///< of the unpressed pad: `finger` equals `height` when it just touches
    double rest = 0;                         ///< of the finger's spring
};

/// At rest, with the finger pressing by its preload.
LeverState at_rest(const FingerSettings& finger, double height) noexcept;
/// N between finger and lever.
double pad_force(const LeverState& state, const FingerSettings& finger) noexcept;
/// `dt` of at most a quarter of a millisecond. Without a finger, `finger` is null.
void move(LeverState& state, const LeverSettings& lever, const FingerSettings* finger, double force, double dt) noexcept;

/// The motion of both under a force. Nothing allocates; equal calls give equal bytes.
class SimulatedLever {
public:
    /// At rest at `height`, with a finger pressing by its preload, or none.
    SimulatedLever(const LeverSettings& lever, const std::optional<FingerSettings>& finger, double height);

    void push(double force) noexcept;       ///< clamped to most_force, NaN is zero; takes effect after the delay
    void advance(double seconds) noexcept;  ///< in steps of at most 50 us
    void throw_at(double velocity) noexcept { state_.velocity = velocity; }  ///< mm/s, of the lever

    double height() const noexcept;  ///< as read by the encoder
    double true_height() const noexcept { return state_.height; }
    const LeverState& state() const noexcept { return state_; }
    double energy() const noexcept;  ///< N mm: of motion, height and springs; the energy of height is 0 at height 0

private:
    LeverSettings lever_;
    std::optional<FingerSettings> finger_;
    LeverState state_;
    double time_ = 0;
    Delayed<double> forces_;
};

}  // namespace tactics
