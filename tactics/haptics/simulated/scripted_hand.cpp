// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/simulated/scripted_hand.h"

#include <algorithm>

namespace tactics {

namespace {

constexpr double kLate = 0.06, kSmooth = 0.02;  // s
constexpr std::size_t kMostFindings = 4096;

}  // namespace

HandSense LateSense::feel(const HandSense& sense, double dt) noexcept {
    if (now_ == 0) smooth_.finger = sense.finger;
    const double share = std::min(1.0, dt / kSmooth);
    smooth_.force = smooth_.force + share * (sense.force - smooth_.force);
    smooth_.finger = smooth_.finger + share * (sense.finger - smooth_.finger);
    // A ring with one entry per tick, at any rate.
    past_[now_ % past_.size()] = smooth_;
    const auto back =
        static_cast<std::size_t>(std::clamp(kLate / std::max(dt, 1e-5), 0.0, static_cast<double>(past_.size() - 1)));
    HandSense felt = now_ >= back ? past_[(now_ - back) % past_.size()] : HandSense{sense.finger, {}};
    ++now_;
    if (length_of(felt.force) <= kFelt) felt.force = {};
    return felt;
}

ScriptedHand::ScriptedHand(const HandField& field) : field_(field) { findings_.reserve(kMostFindings); }

Point3 ScriptedHand::move(const HandSense& sense, double dt) noexcept {
    time_ += dt;
    in_phase_ += dt;
    finger_ = sense.finger;
    if (!begun_) at_ = sense.finger;
    begun_ = true;
    const HandSense felt = late_.feel(sense, dt);
    force_ = felt.force;
    felt_at_ = felt.finger;
    go(dt);
    // A hand that leads its finger by more than this would have to press harder than anybody does.
    constexpr double kMostLead = 8;
    const Point3 lead = at_ - finger_;
    if (length_of(lead) > kMostLead) at_ = finger_ + kMostLead * unit(lead);
    return at_;
}

void ScriptedHand::find(std::string_view what, const Point3& place) noexcept {
    if (findings_.size() < findings_.capacity()) findings_.push_back({what, place, time_});
    press_key(what == "point" ? 4 : what == "curve" ? 3 : 1);
}

void ScriptedHand::press_key(unsigned key) noexcept {
    constexpr double kPressed = 0.1;  // s
    pressed_ = 1u << (key - 1);
    pressed_until_ = time_ + kPressed;
}

void ScriptedHand::go_towards(const Point3& goal, double speed, double dt) noexcept {
    const Point3 way = goal - at_;
    const double length = length_of(way);
    at_ = length > speed * dt ? at_ + speed * dt / length * way : goal;
}

void ScriptedHand::press(double dt) noexcept {
    constexpr double kPushes = 3;  // mm below the finger
    const double steep = length_of(force_) > 0 ? std::clamp(force_.z / length_of(force_), 0.0, 1.0) : 1;
    at_.z += std::min(1.0, dt / 0.03) * (std::max(finger_.z - kPushes * steep, -kPushes) - at_.z);
}

}  // namespace tactics
