// SPDX-License-Identifier: Apache-2.0
// A simulated haptic arm that pushes a fingertip in space, with a finger in its thimble and a hand behind it.
//
// Axes of a device: x to the right, y upwards, z towards the person; the origin is the middle of the workspace.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>

#include "tactics/haptics/simulated/delayed.h"
#include "tactics/haptics/simulated/lever.h"
#include "tactics/point3.h"

namespace tactics {

/// The machine. Lengths in mm, forces in N, times in s. Values that the makers do not publish are assumed, and marked as such.
struct ArmSettings {
    double width = 160, height = 120, depth = 70;  ///< of its workspace
    double resolution = 0.055;                     ///< smallest step in position that it detects
    double noise = 0;                              ///< additional standard deviation of its positions
    double most_force = 3.3;
    double most_stiffness = 1.02;   ///< N/mm, as stated by its maker, in its weakest direction
    double mass_g = 45;             ///< felt at the fingertip
    double damping_ns_per_m = 0.3;  ///< assumed
    double friction = 0.26;
    double rate_hz = 1000;
    double delay = 0;  ///< from a measurement to its force, besides the hold
    bool operator==(const ArmSettings&) const = default;
};

struct NamedArm {
    std::string_view name, what;
    ArmSettings arm;
};
/// The devices of the papers. Workspace and resolution of Omni and Desktop: table 1 of "Haptic media as a stand-alone medium"; of
/// the Phantom: 13 x 18 x 25 cm ("Haptic Representation of Scientific Data", section 3) and 0.07 mm ("Design of a Haptic Graphing
/// System"). Force, stiffness, inertia and friction are those of the makers' data sheets, from memory; the Phantom has 8.5 N, of
/// which the loop uses at most 8 (loop/safety.h).
inline constexpr std::array<NamedArm, 3> kArms = {
    {{"omni", "Phantom Omni", {}},
     {"desktop", "Phantom Desktop", {160, 120, 120, 0.023, 0, 7.9, 1.48, 45, 0.3, 0.06, 1000, 0}},
     {"phantom", "PHANToM of the first papers", {250, 180, 130, 0.07, 0, 8, 3.5, 75, 0.3, 0.04, 1000, 0}}}};

/// Its parameters and those of the finger in a text file (parameter_file.h): `arm = desktop`, `arm.delay = 0.001 s`, `finger =
/// soft`.
struct ArmFile {
    ArmSettings arm;
    FingerSettings finger = kFingers[1].finger;
    bool lifted = false;  ///< no finger is in it: `finger = none`
    std::optional<FingerSettings> in_it() const { return lifted ? std::nullopt : std::optional(finger); }
    bool operator==(const ArmFile&) const = default;
};
ArmFile read_arm(std::string_view text, std::string_view origin);  ///< Throws Error(usage) with the line
std::string to_text(const ArmFile& file);

/// One of its directions as a lever, for the analysis of levers (stability.h): without gravity.
LeverSettings as_lever(const ArmSettings& arm);

/// The motion under forces and a hand. The thimble holds the finger in both directions. Nothing allocates; equal calls give equal
/// bytes.
class SimulatedArm {
public:
    /// At rest at `place`, in the axes of the device.
    SimulatedArm(const ArmSettings& arm, const std::optional<FingerSettings>& finger, const Point3& place);

    void push(const Point3& force) noexcept;  ///< clamped to most_force, zero if not finite; takes effect after the delay
    /// The hand's own position moves there meanwhile, at constant speed. Steps of at most 50 us.
    void advance(double seconds, const Point3& hand) noexcept;

    Point3 told() noexcept;  ///< the reported position: rounded and noisy
    const Point3& place() const noexcept { return place_; }
    const Point3& velocity() const noexcept { return velocity_; }
    const Point3& pushed() const noexcept { return pushed_; }  ///< current force of its motors, N

private:
    Point3 on_finger() const noexcept;  // N, from the thimble
    void step(const Point3& force, const Point3& hand, const Point3& hand_velocity, double dt) noexcept;

    ArmSettings arm_;
    std::optional<FingerSettings> finger_;
    Point3 place_, velocity_, fingertip_, finger_velocity_, hand_;
    Point3 pushed_;
    double time_ = 0;
    Delayed<Point3> forces_;
    std::mt19937_64 random_{1};
};

}  // namespace tactics
