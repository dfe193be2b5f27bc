// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/simulated/arm.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "tactics/haptics/loop/safety.h"
#include "tactics/haptics/simulated/parameter_file.h"

namespace tactics {

namespace {

constexpr double kArmStep = 50e-6;  // s, as the lever's
constexpr double kArmMmPerM = 1000, kArmGPerKg = 1000;

constexpr FileParameter kArmParameters[] = {
    {"arm.width", "mm", 20, 2000, "of its workspace, from left to right"},
    {"arm.height", "mm", 20, 2000, "upwards"},
    {"arm.depth", "mm", 20, 2000, "towards the person"},
    {"arm.resolution", "mm", 0, 1, "smallest step in position that it detects"},
    {"arm.noise", "mm", 0, 1, "standard deviation of its positions"},
    {"arm.force", "N", 0.1, SafetyLimits{}.most_force, "greatest force sent to it"},
    {"arm.stiffness", "N/mm", 0.05, 50, "stated by its maker"},
    {"arm.mass", "g", 1, 5000, "felt at the fingertip"},
    {"arm.damping", "N s/m", 0, 100, "of motors and bearings"},
    {"arm.friction", "N", 0, 10, "the same at any speed"},
    {"arm.rate", "Hz", 100, kMostRateHz, "forces per second"},
    {"arm.delay", "s", 0, kMostDelay, "from a measurement to its force"},
    {"finger.mass", "g", 1, 1000, "of the fingertip"},
    {"finger.stiffness", "N/mm", 0.01, 10, "of what holds it"},
    {"finger.damping", "N s/m", 0, 100, "of what holds it"},
    {"finger.pad-stiffness", "N/mm", 0.1, 10, "of its soft pad"},
    {"finger.pad-damping", "N s/m", 0, 20, "of its soft pad"},
};
constexpr double ArmSettings::*kOfArm[] = {&ArmSettings::width,          &ArmSettings::height,  &ArmSettings::depth,
                                           &ArmSettings::resolution,     &ArmSettings::noise,   &ArmSettings::most_force,
                                           &ArmSettings::most_stiffness, &ArmSettings::mass_g,  &ArmSettings::damping_ns_per_m,
                                           &ArmSettings::friction,       &ArmSettings::rate_hz, &ArmSettings::delay};
constexpr double FingerSettings::*kOfFinger[] = {&FingerSettings::mass_g, &FingerSettings::stiffness,
                                                 &FingerSettings::damping_ns_per_m, &FingerSettings::pad_stiffness,
                                                 &FingerSettings::pad_damping_ns_per_m};
static_assert(std::size(kOfArm) + std::size(kOfFinger) == std::size(kArmParameters));

double& value_of(std::size_t index, ArmFile& file) {
    return index < std::size(kOfArm) ? file.arm.*kOfArm[index] : file.finger.*kOfFinger[index - std::size(kOfArm)];
}

}  // namespace

ArmFile read_arm(std::string_view text, std::string_view origin) {
    constexpr std::string_view kPresets[] = {"arm", "finger"};
    ArmFile file;
    const auto take = [&](std::string_view name, std::string_view word, const std::string& place) {
        if (name == "arm")
            file.arm = preset(kArms, word, place, name).arm;
        else if (word == "none")
            file.lifted = true;
        else
            file.finger = preset(kFingers, word, place, name).finger;
    };
    read_parameters(text, origin,
                    {"an arm", kPresets, kArmParameters, take, [&](std::size_t i, double value) { value_of(i, file) = value; }});
    return file;
}

std::string to_text(const ArmFile& file) {
    std::string text = file.lifted ? "finger = none\n" : "";
    ArmFile copy = file;
    for (std::size_t i = 0; i < std::size(kArmParameters); ++i) text += parameter_line(kArmParameters[i], value_of(i, copy));
    return text;
}

LeverSettings as_lever(const ArmSettings& arm) {
    LeverSettings lever;
    lever.mass_g = arm.mass_g;
    lever.damping_ns_per_m = arm.damping_ns_per_m;
    lever.friction = arm.friction;
    lever.gravity_m_per_s2 = 0;
    lever.encoder_step = arm.resolution;
    lever.most_force = arm.most_force;
    lever.rate_hz = arm.rate_hz;
    lever.delay = arm.delay;
    return lever;
}

SimulatedArm::SimulatedArm(const ArmSettings& arm, const std::optional<FingerSettings>& finger, const Point3& place)
    : arm_(arm), finger_(finger), place_(place), fingertip_(place), hand_(place) {}

void SimulatedArm::push(const Point3& force) noexcept {
    forces_.give(time_ + arm_.delay, is_finite(force) ? within(force, arm_.most_force) : Point3{});
}

Point3 SimulatedArm::on_finger() const noexcept {
    if (!finger_) return {};
    return finger_->pad_stiffness * (place_ - fingertip_) +
           finger_->pad_damping_ns_per_m / kArmMmPerM * (velocity_ - finger_velocity_);
}

// Velocities first, places from the new velocities: keeps the energy of springs bounded.
void SimulatedArm::step(const Point3& force, const Point3& hand, const Point3& hand_velocity, double dt) noexcept {
    const Point3 pad = on_finger();
    const double gain = kArmMmPerM * dt / (arm_.mass_g / kArmGPerKg);
    velocity_ = velocity_ + gain * (force - pad - arm_.damping_ns_per_m / kArmMmPerM * velocity_);
    // Dry friction takes velocity away, and holds what it can stop.
    const double speed = length_of(velocity_), lost = arm_.friction * gain;
    velocity_ = speed > lost ? (1 - lost / speed) * velocity_ : Point3{};
    place_ = place_ + dt * velocity_;
    const auto stop = [](double& at, double& speed_there, double most) {
        if (std::abs(at) <= most) return;
        at = std::copysign(most, at);
        speed_there = 0;
    };
    stop(place_.x, velocity_.x, arm_.width / 2);
    stop(place_.y, velocity_.y, arm_.height / 2);
    stop(place_.z, velocity_.z, arm_.depth / 2);
    if (!finger_) return;
    const Point3 held =
        finger_->stiffness * (hand - fingertip_) + finger_->damping_ns_per_m / kArmMmPerM * (hand_velocity - finger_velocity_);
    finger_velocity_ = finger_velocity_ + kArmMmPerM * dt / (finger_->mass_g / kArmGPerKg) * (pad + held);
    fingertip_ = fingertip_ + dt * finger_velocity_;
}

void SimulatedArm::advance(double seconds, const Point3& hand) noexcept {
    constexpr double kNow = 1e-9;  // s; sums of ticks are not exact
    if (!(seconds > 0) || !is_finite(hand)) return;
    const double begin = time_, end = time_ + seconds;
    const Point3 from = hand_, hand_velocity = 1 / seconds * (hand - from);
    while (end - time_ > kNow) {
        pushed_ = forces_.at(time_ + kNow);
        const double whole = std::min(end, time_ + kArmStep),
                     until = std::min(whole, std::max(forces_.next(whole), time_ + 2 * kNow));
        step(pushed_, from + (time_ - begin) * hand_velocity, hand_velocity, until - time_);
        time_ = until;
    }
    hand_ = hand;
}

Point3 SimulatedArm::told() noexcept {
    std::normal_distribution<double> noise(0, arm_.noise > 0 ? arm_.noise : 1);
    const auto tell = [&](double at) {
        if (arm_.noise > 0) at += noise(random_);
        return arm_.resolution > 0 ? std::floor(at / arm_.resolution + 0.5) * arm_.resolution : at;
    };
    return {tell(place_.x), tell(place_.y), tell(place_.z)};
}

}  // namespace tactics
