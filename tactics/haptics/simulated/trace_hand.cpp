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
            case 5: return step_back(dt);
            case 6: return slide(dt);
            case 7: return rest(dt);
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
    // On both sides of a tick the finger comes down to the axis; beside the crest of a curve that runs low it does not.
    bool is_ground_beside(double x) const noexcept {
        constexpr double kWithin = 6;  // mm
        const auto any = [this](double from, double to) {
            return std::any_of(ground_.begin() + static_cast<std::ptrdiff_t>(place_on_axis(from)),
                               ground_.begin() + static_cast<std::ptrdiff_t>(place_on_axis(to)) + 1, [](bool is) { return is; });
        };
        return any(x - kWithin, x) && any(x, x + kWithin);
    }
    // Down, and somewhat away from where it will go, as it may have come down on a tick.
    void go_down(double dt) noexcept {
        go_towards({at_.x, field_.height + 3, -kPress}, 2 * field_.speed, dt);
        if ((force_.y < -3 * kFelt && finger_.y > field_.height - 3) || in_phase_ > 6) next();
    }
    void step_back(double dt) noexcept {
        constexpr double kBack = 6;  // mm
        const double goal = std::clamp(passed_ - side_ * kBack, 0.0, field_.width);
        go_towards({goal, field_.height + 2, -kPress}, field_.speed / 2, dt);
        feel_ground();
        if (std::abs(finger_.x - goal) > 1 && in_phase_ < 2) return;
        passed_ = finger_.x;
        next();
    }
    void feel_ground() noexcept {
        constexpr double kOnGround = 0.1;  // mm
        if (finger_.y > field_.height - kOnGround) ground_[place_on_axis(finger_.x)] = true;
    }
    // Along the lower axis, to the side where there is more of it. A bump resists on its rising side; after the top the finger
    // slips down, so the hand turns, comes back slowly, and goes a quarter of a bump beyond the point of greatest resistance:
    // near the top. Where a curve pulls, too, it presses harder.
    void slide(double dt) noexcept {
        constexpr double kQuarter = 1.25, kPush = 0.25;  // mm, N
        constexpr double kFar = 24;                      // mm
        const double way = passes_ == 1 ? -side_ : side_, against = -way * force_.x;
        go_towards({at_.x + way * field_.speed, field_.height + (again_ ? 5 : 2), -kPress}, field_.speed / (passes_ > 0 ? 8 : 2),
                   dt);
        foot_ = std::max(foot_, finger_.y);
        feel_ground();
        if (passes_ > 0) feel_bump();
        const bool was_there =
            passes_ == 0 && (side_ * (felt_at_.x - passed_) < 0 || (!again_ && low_[place_on_axis(felt_at_.x)]));
        // Beyond a tick a curve may still hold it back.
        const bool is_beyond = passes_ > 0 ? bump_.is_passed(finger_.x) : strongest_ > kPush && against < kFelt;
        if (against > strongest_ && !was_there) {
            strongest_ = against;
            top_ = felt_at_.x + way * kQuarter;
        } else if (is_beyond) {
            strongest_ = 0;
            if (passes_ == 2) return rests_ = 0, light_ = 0.7, next();
            if (passes_ == 0) turned_ = finger_.x;
            bump_back_ = bump_;
            bump_ = {finger_.x};
            ++passes_;
            at_.x = finger_.x;
        }
        const bool is_at_side = way < 0 ? finger_.x < 0.5 : finger_.x > field_.width - 0.5;
        if (passes_ > 0 && (is_at_side || std::abs(finger_.x - turned_) > kFar))
            go_on_from(turned_ + (again_ ? 0 : side_ * kFar));
        // At its end once back along all of it.
        if (side_ < 0 ? finger_.x < 2 : finger_.x > field_.width - 2) {
            side_ = -side_;
            go_on_from(finger_.x);
            if (back_) give_up();
            back_ = true;
        }
        if (in_phase_ > 20) {
            side_ = finger_.x > field_.width / 2 ? -1 : 1;
            go_on_from(finger_.x);
            give_up();
        }
    }
    // It finds none where only the axis pushes: once more where the curve comes down, too.
    void give_up() noexcept {
        done_ = again_;
        again_ = true;
        back_ = false;
        tries_ = 0;
        in_phase_ = 0;
    }
    // Lightly, so that it just feels it: who presses slips off the top. What pushes the finger aside is the flank on which it
    // still is: the hand leads it back until nothing does. Where the finger is not higher then than beside the bump, that was
    // none, but a curve: on along the axis.
    void rest(double dt) noexcept {
        constexpr double kTouch = 0.13, kFirmer = 5, kMostFirm = 2;  // N, mm/s each N, mm
        constexpr double kLead = 2, kLevel = 0.2, kPatience = 10;    // mm/s, both by the slope of the push; s
        constexpr double kHigher = 1.3, kWide = 16;                  // mm
        rests_ += dt;
        light_ = std::clamp(light_ + kFirmer * (kTouch + force_.y) * dt, 0.2, kMostFirm);
        at_.y = std::min(field_.height + 2, finger_.y + light_);
        const double slope = force_.y < 0 ? std::clamp(force_.x / -force_.y, -1.0, 1.0) : 0;
        top_ -= kLead * slope * dt;
        go_towards({top_, at_.y, -kPress}, field_.speed / 8, dt);
        if (std::abs(at_.x - top_) > 0.1 || std::abs(slope) > kLevel || std::abs(kTouch + force_.y) > kFelt) in_phase_ = 0;
        if (in_phase_ < 0.3 && rests_ < kPatience) return;
        if (is_tick_by_its_sides()) {
            const bool rests_there = rests_ < kPatience && foot_ - finger_.y > kHigher && std::abs(finger_.x - middle()) < 0.5;
            if (rests_there) find("tick");
            // Where a curve pulls, too, the finger is seldom left alone on the top.
            if (!rests_there && again_) find("tick", {middle(), bump_.top, finger_.z});
            if (rests_there || again_) return next();
        }
        phase_ -= 1;
        const double beyond = finger_.x + side_ * kWide;
        go_on_from(side_ < 0 ? std::min(beyond, turned_) : std::max(beyond, turned_));
    }
    // A bump that it slowly passes over: from half its height to half its height, and how high it is.
    struct Bump {
        double begun = 0, foot = 0, top = INFINITY, from = NAN, to = NAN;  // mm
        double middle() const noexcept { return (from + to) / 2; }
        bool is_high() const noexcept { return foot - top > 0.7; }
        // A curve attracts farther than a tick is wide: it does not lift a finger in so short a stretch.
        bool is_tick() const noexcept {
            constexpr double kHighest = 2.2, kWidest = 4.5;  // mm
            return is_high() && foot - top < kHighest && std::abs(to - from) < kWidest;
        }
        bool is_passed(double x) const noexcept { return std::abs(x - to) > 3; }
    };
    void feel_bump() noexcept {
        constexpr double kHalf = 0.5, kSettles = 1;  // mm
        if (!std::isnan(bump_.to) || std::abs(finger_.x - bump_.begun) < kSettles) return;
        if (std::isnan(bump_.from)) bump_.foot = std::max(bump_.foot, finger_.y);
        if (finger_.y < bump_.foot - kHalf) {
            if (std::isnan(bump_.from)) bump_.from = finger_.x;
            bump_.top = std::min(bump_.top, finger_.y);
        } else if (!std::isnan(bump_.from)) {
            // Down again on the other side, or back where it began to rise.
            constexpr double kNarrowest = 1;  // mm
            const double over = bump_.from > bump_.begun ? finger_.x - bump_.from : bump_.from - finger_.x;
            if (bump_.is_high() && over > kNarrowest)
                bump_.to = finger_.x;
            else
                bump_.from = NAN, bump_.top = INFINITY;
        }
    }
    // By both slow passes.
    bool is_tick_by_its_sides() const noexcept {
        constexpr double kAgree = 2.5;  // mm: a finger lags behind on both ways
        return bump_back_.is_tick() && bump_.is_tick() && std::abs(bump_back_.middle() - bump_.middle()) < kAgree &&
               is_ground_beside(middle());
    }
    double middle() const noexcept { return (bump_back_.middle() + bump_.middle()) / 2; }
    void go_on_from(double at) noexcept {
        constexpr int kMostTries = 8;
        passed_ = at;
        strongest_ = in_phase_ = 0;
        passes_ = 0;
        if (++tries_ > kMostTries) give_up();
    }

    int tries_ = 0;
    double foot_ = 0, rests_ = 0, light_ = 0, passed_ = 0, turned_ = 0;
    bool back_ = false, again_ = false;
    std::array<bool, 400> low_{};     // places along the axis to which the curve comes down
    std::array<bool, 400> ground_{};  // and where the finger has been on it
    int lane_ = 0, ends_ = 0;
    Point3 other_end_;
    double held_ = 0, side_ = -1;
    LineWalk walk_;
    double strongest_ = 0, top_ = 0;
    Bump bump_, bump_back_;
    int passes_ = 0;  // over a bump: quickly, slowly back and slowly again
};

}  // namespace

std::unique_ptr<Hand> trace_hand(const HandField& field) { return std::make_unique<Trace>(field); }

}  // namespace tactics
