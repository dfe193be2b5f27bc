// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

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
        next();
    }
    void go_down(double dt) noexcept {
        go_towards({at_.x, field_.height + 3, -kPress}, 2 * field_.speed, dt);
        if ((force_.y < -3 * kFelt && finger_.y > field_.height - 3) || in_phase_ > 6) next();
    }
    // Along the lower axis, to the side where there is more of it. A bump resists on its rising side; after the top the finger
    // slips down, so the hand turns, comes back slowly, and rests a quarter of a bump beyond the point of greatest resistance: on
    // the top.
    void slide(double dt) noexcept {
        constexpr double kQuarter = 1.25, kPush = 0.25;  // mm, N
        const double way = over_ ? -side_ : side_, against = -way * force_.x;
        go_towards({at_.x + way * field_.speed, field_.height + 2, -kPress}, field_.speed / (over_ ? 8 : 2), dt);
        if (against > strongest_) {
            strongest_ = against;
            top_ = felt_at_.x + way * kQuarter;
        } else if (strongest_ > kPush && against < kFelt) {
            strongest_ = 0;
            if (over_) return next();
            over_ = true;
            at_.x = finger_.x;
        }
        if ((side_ < 0 ? finger_.x < 2 : finger_.x > field_.width - 2) || in_phase_ > 20) done_ = true;
    }
    // Lightly: who presses slips off the top.
    void rest(double dt) noexcept {
        constexpr double kLight = 0.7;  // mm, some 0.2 N at the default finger
        go_towards({top_, std::min(field_.height + 2, finger_.y + kLight), -kPress}, field_.speed / 8, dt);
        if (std::abs(at_.x - top_) > 1e-9) in_phase_ = 0;
        if (in_phase_ < 0.4) return;
        find("tick");
        next();
    }

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
