// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/simulated/hand.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tactics/haptics/simulated/scripted_hand.h"

namespace tactics {

namespace {

class ToAndFro final : public ScriptedHand {
public:
    using ScriptedHand::ScriptedHand;

private:
    void go(double dt) noexcept override {
        const bool solid = field_.depth > 0;
        const double beside = solid ? kBesideSolid * field_.width : 0, goal = phase_ % 2 == 0 ? beside : field_.width - beside;
        go_towards({goal, field_.height / 2, solid ? at_.z : -kPress}, field_.speed, dt);
        if (solid) press(dt);
        if (at_.x == goal) next();
    }
};

class Points final : public ScriptedHand {
public:
    using ScriptedHand::ScriptedHand;

private:
    // Rows closer than a sphere is wide. Where a push is strongest, something is on the other side; a grid pushes less than that.
    void go(double dt) noexcept override {
        constexpr double kRow = 2, kPush = 0.25, kAway = 1.5;  // mm, N, mm
        const double y = 2 + kRow * phase_;
        if (y > field_.height - 2) {
            done_ = true;
            return;
        }
        const double goal = phase_ % 2 == 0 ? field_.width : 2.0;
        const bool at_row = std::abs(at_.y - y) < 0.5;
        go_towards({at_row ? goal : at_.x, y, 0}, field_.speed / 2, dt);
        const double push = flat_length(force_);
        if (push > strongest_) {
            strongest_ = push;
            there_ = finger_ - kAway * unit(flat(force_));
        } else if (push < kPush / 2) {
            if (strongest_ > kPush) find("point", there_);
            strongest_ = 0;
        }
        if (at_row && std::abs(at_.x - goal) < 0.5) next();
    }
    double strongest_ = 0;
    Point3 there_;
};

class Led final : public ScriptedHand {
public:
    using ScriptedHand::ScriptedHand;

private:
    void go(double dt) noexcept override {
        constexpr double kBehind = 0.05, kRests = 1.2, kStill = 0.3;  // s, s, mm
        at_ = at_ + std::min(1.0, dt / kBehind) * flat(finger_ - at_);
        go_towards({at_.x, at_.y, -kPress}, field_.speed, dt);
        if (flat_length(finger_ - rests_at_) > kStill || at_.z > -kPress) {
            rests_at_ = finger_;
            in_phase_ = 0;
        }
        if (in_phase_ < kRests) return;
        const auto key = static_cast<std::size_t>(phase_);
        if (key < field_.keys.size()) press_key(field_.keys[key]);
        done_ = !field_.keys.empty() && key == field_.keys.size();
        next();
    }
    Point3 rests_at_;
};

template <typename Kind>
std::unique_ptr<Hand> make(const HandField& field) {
    return std::make_unique<Kind>(field);
}

}  // namespace

const std::vector<HandKind>& hands() {
    static const std::vector<HandKind> kHands = {
        {"to-and-fro", "moves through the middle, from side to side", false, false, make<ToAndFro>},
        {"trace", "finds a curve from the axes, follows it to its end and stops at a tick", true, true, trace_hand},
        {"points", "sweeps the field in rows and notes where points are", true, true, make<Points>},
        {"sections", "follows a surface along two lines through its middle", false, true, sections_hand},
        {"led", "lets itself be led to where its keys say", true, false, make<Led>},
    };
    return kHands;
}

}  // namespace tactics
