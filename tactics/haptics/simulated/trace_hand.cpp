// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "tactics/haptics/simulated/line_walk.h"
#include "tactics/haptics/simulated/scripted_hand.h"

namespace tactics {

namespace {

class Trace final : public ScriptedHand {
public:
    using ScriptedHand::ScriptedHand;

private:
    void go(double dt) noexcept override {
        switch (phase_) {
            case 0: return go_home(dt);
            case 1: return climb(dt);
            case 2: return settle(dt);
            case 3: return follow(dt);
            case 4: return go_down(dt);
            case 5: return slide(dt);
            case 6: return rest(dt);
            default: done_ = true;
        }
    }
    // Into the corner of the axes, until both push.
    void go_home(double dt) noexcept {
        go_towards({-3, field_.height + 3, -kPress}, 2 * field_.speed, dt);
        if ((force_.x > 2 * kFelt && force_.y < -2 * kFelt) || in_phase_ > 6) next();
    }
    // Up along the left axis, then down and up again farther to the right. A bump first holds back and then helps; a curve helps
    // first.
    void climb(double dt) noexcept {
        // The lanes are not quite upright: between two steep flanks an upright one might meet nothing that pulls.
        constexpr double kLane = 12, kOffAxis = 5, kSlant = 5;  // mm
        const double way = lane_ % 2 == 0 ? -1 : 1, lane = lane_ == 0 ? -2 : kLane * lane_ + kSlant * at_.y / field_.height;
        go_towards({lane, at_.y + way * field_.speed, -kPress}, field_.speed, dt);
        const double help = force_.y * way;
        held_ = help < -kFelt ? 0.25 : std::max(0.0, held_ - dt);
        // What pulls aside in the middle of the field is no grid, which only holds back.
        const bool aside = lane_ > 0 && std::abs(at_.x - lane) < 1 && std::abs(force_.x) > 3 * kFelt;
        // Near the lower axis that one helps.
        if ((aside || (help > 2 * kFelt && held_ == 0)) && finger_.y < field_.height - kOffAxis) {
            at_ = {finger_.x, finger_.y, -kPress};
            next();
        } else if (way < 0 ? finger_.y < 0 : finger_.y > field_.height - 6) {
            ++lane_;
            done_ = kLane * lane_ > field_.width;
        }
    }
    // Lets itself be pulled until it rests.
    void settle(double dt) noexcept {
        at_ = at_ + std::min(1.0, dt / 0.05) * Point3{finger_.x - at_.x, finger_.y - at_.y, 0};
        if (in_phase_ < 0.6) return;
        find("curve");
        walk_.begin(finger_, {-1, 0, 0}, field_.speed);
        next();
    }
    // To both ends of the line, and once more along all of it where the last one is that at the left.
    void follow(double dt) noexcept {
        const LineWalk::State state = walk_.go(finger_, force_, dt, at_);
        remember_low();
        if (state == LineWalk::State::walks) return;
        if (state == LineWalk::State::ended && (ends_ == 0 || (ends_ == 1 && walk_.end().x < other_end_.x))) {
            ++ends_;
            other_end_ = walk_.end();
            walk_.begin(finger_, -1.0 * walk_.came_by(), field_.speed);
            return;
        }
        if (state == LineWalk::State::ended)
            find("end of the curve", walk_.end());
        else
            find("closed curve");
        side_ = finger_.x > field_.width / 2 ? -1 : 1;
        passed_ = finger_.x;
        next();
    }
    // Where the curve comes down to the axis it pushes, too, and ticks are not told from it.
    void remember_low() noexcept {
        constexpr double kLow = 6, kBeside = 5;  // mm
        if (finger_.y < field_.height - kLow) return;
        const std::size_t last = place_on_axis(finger_.x + kBeside);
        for (std::size_t i = place_on_axis(finger_.x - kBeside); i <= last; ++i) low_[i] = true;
    }
    std::size_t place_on_axis(double x) const noexcept {
        return static_cast<std::size_t>(std::clamp(x / field_.width, 0.0, 1.0) * static_cast<double>(low_.size() - 1));
    }
    void go_down(double dt) noexcept {
        go_towards({at_.x, field_.height + 3, -kPress}, 2 * field_.speed, dt);
        if ((force_.y < -3 * kFelt && finger_.y > field_.height - 3) || in_phase_ > 6) next();
    }
    // Along the lower axis, to the side where there is more of it. A bump resists on its rising side; after the top the finger
    // slips down, so the hand turns, comes back slowly, and goes a quarter of a bump beyond the point of greatest resistance:
    // near the top.
    void slide(double dt) noexcept {
        constexpr double kQuarter = 1.25, kPush = 0.25, kFar = 15;  // mm, N, mm
        const double way = over_ ? -side_ : side_, against = -way * force_.x;
        go_towards({at_.x + way * field_.speed, field_.height + 2, -kPress}, field_.speed / (over_ ? 8 : 2), dt);
        foot_ = std::max(foot_, finger_.y);
        const bool was_there = !over_ && (side_ * (felt_at_.x - passed_) < 0 || low_[place_on_axis(felt_at_.x)]);
        if (against > strongest_ && !was_there) {
            strongest_ = against;
            top_ = felt_at_.x + way * kQuarter;
        } else if (strongest_ > kPush && against < kFelt) {
            strongest_ = 0;
            if (over_) return rests_ = 0, light_ = 0.7, next();
            over_ = true;
            at_.x = turned_ = finger_.x;
        }
        if (over_ && std::abs(finger_.x - turned_) > kFar) go_on_from(turned_ + side_ * kFar);
        // At its end once back along all of it.
        if (side_ < 0 ? finger_.x < 2 : finger_.x > field_.width - 2) {
            side_ = -side_;
            go_on_from(finger_.x);
            done_ = done_ || back_;
            back_ = true;
        }
        done_ = done_ || in_phase_ > 20;
    }
    // Lightly, so that it just feels it: who presses slips off the top. What pushes the finger aside is the flank on which it
    // still is: the hand leads it back until nothing does. Where the finger is not higher then than beside the bump, that was
    // none, but a curve: on along the axis.
    void rest(double dt) noexcept {
        constexpr double kTouch = 0.13, kFirmer = 5, kMostFirm = 2;  // N, mm/s each N, mm
        constexpr double kLead = 2, kLevel = 0.3, kPatience = 10;    // mm/s, both by the slope of the push; s
        constexpr double kHigher = 1.3, kWide = 16;                  // mm
        rests_ += dt;
        light_ = std::clamp(light_ + kFirmer * (kTouch + force_.y) * dt, 0.2, kMostFirm);
        at_.y = std::min(field_.height + 2, finger_.y + light_);
        const double slope = force_.y < 0 ? std::clamp(force_.x / -force_.y, -1.0, 1.0) : 0;
        top_ -= kLead * slope * dt;
        go_towards({top_, at_.y, -kPress}, field_.speed / 8, dt);
        if (std::abs(at_.x - top_) > 0.1 || std::abs(slope) > kLevel || std::abs(kTouch + force_.y) > kFelt) in_phase_ = 0;
        if (in_phase_ < 0.3 && rests_ < kPatience) return;
        if (rests_ < kPatience && foot_ - finger_.y > kHigher) {
            find("tick");
            return next();
        }
        phase_ -= 1;
        go_on_from(finger_.x + side_ * kWide);
    }
    void go_on_from(double at) noexcept {
        constexpr int kMostTries = 8;
        passed_ = at;
        strongest_ = in_phase_ = 0;
        over_ = false;
        done_ = ++tries_ > kMostTries;
    }

    int tries_ = 0;
    double foot_ = 0, rests_ = 0, light_ = 0, passed_ = 0, turned_ = 0;
    bool back_ = false;
    std::array<bool, 100> low_{};  // places along the axis to which the curve comes down
    int lane_ = 0, ends_ = 0;
    Point3 other_end_;
    double held_ = 0, side_ = -1;
    LineWalk walk_;
    double strongest_ = 0, top_ = 0;
    bool over_ = false;
};

}  // namespace

std::unique_ptr<Hand> trace_hand(const HandField& field) { return std::make_unique<Trace>(field); }

}  // namespace tactics
