// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/simulated/hand.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace tactics {

namespace {

constexpr double kLate = 0.06, kSmooth = 0.02;  // s
constexpr double kFelt = 0.1;                   // N
constexpr double kPress = 1.5;                  // mm by which the hand is inside the wall: about half a newton
constexpr double kBeside = 0.08;                // of a solid, at whose sides a hand that presses on it would slip off
constexpr std::size_t kMostFindings = 4096;

double flat_length(const Point3& v) { return std::hypot(v.x, v.y); }
Point3 flat(const Point3& v) { return {v.x, v.y, 0}; }

// What has been felt by now.
class LateForce {
public:
    Point3 feel(const Point3& force, double dt) noexcept {
        smooth_ = smooth_ + std::min(1.0, dt / kSmooth) * (force - smooth_);
        // A ring with one entry per tick, at any rate.
        past_[now_ % past_.size()] = smooth_;
        const auto back =
            static_cast<std::size_t>(std::clamp(kLate / std::max(dt, 1e-5), 0.0, static_cast<double>(past_.size() - 1)));
        const Point3 felt = now_ >= back ? past_[(now_ - back) % past_.size()] : Point3{};
        ++now_;
        return length_of(felt) > kFelt ? felt : Point3{};
    }

private:
    std::array<Point3, 2048> past_{};
    std::size_t now_ = 0;
    Point3 smooth_;
};

class ScriptedHand : public Hand {
public:
    explicit ScriptedHand(const HandField& field) : field_(field) { findings_.reserve(kMostFindings); }
    Point3 move(const HandSense& sense, double dt) noexcept final {
        time_ += dt;
        in_phase_ += dt;
        finger_ = sense.finger;
        if (!begun_) at_ = sense.finger;
        begun_ = true;
        force_ = late_.feel(sense.force, dt);
        go(dt);
        // A hand that leads its finger by more than this would have to press harder than anybody does.
        constexpr double kMostLead = 8;
        const Point3 lead = at_ - finger_;
        if (length_of(lead) > kMostLead) at_ = finger_ + kMostLead * unit(lead);
        return at_;
    }
    const std::vector<HandFinding>& findings() const noexcept final { return findings_; }
    bool is_done() const noexcept override { return done_; }
    unsigned keys() const noexcept final { return time_ < pressed_until_ ? pressed_ : 0; }

protected:
    virtual void go(double dt) noexcept = 0;
    void find(std::string_view what) noexcept { find(what, finger_); }
    void find(std::string_view what, const Point3& place) noexcept {
        if (findings_.size() < findings_.capacity()) findings_.push_back({what, place, time_});
        press_key(what == "point" ? 4 : what == "curve" ? 3 : 1);
    }
    void press_key(unsigned key) noexcept {
        constexpr double kPressed = 0.1;  // s
        pressed_ = 1u << (key - 1);
        pressed_until_ = time_ + kPressed;
    }
    void go_towards(const Point3& goal, double speed, double dt) noexcept {
        const Point3 way = goal - at_;
        const double length = length_of(way);
        at_ = length > speed * dt ? at_ + speed * dt / length * way : goal;
    }
    // Downwards on a solid, over which it then goes: about a newton, less on a steep place, as it would not get up there else,
    // and not below its foot.
    void press(double dt) noexcept {
        constexpr double kPushes = 3;  // mm below the finger
        const double steep = length_of(force_) > 0 ? std::clamp(force_.z / length_of(force_), 0.0, 1.0) : 1;
        at_.z += std::min(1.0, dt / 0.03) * (std::max(finger_.z - kPushes * steep, -kPushes) - at_.z);
    }
    void next() noexcept { ++phase_, in_phase_ = 0; }

    HandField field_;
    Point3 at_, finger_, force_;
    double time_ = 0, in_phase_ = 0;
    int phase_ = 0;
    bool done_ = false;

private:
    bool begun_ = false;
    unsigned pressed_ = 0;
    double pressed_until_ = 0;
    LateForce late_;
    std::vector<HandFinding> findings_;
};

class ToAndFro final : public ScriptedHand {
public:
    using ScriptedHand::ScriptedHand;

private:
    void go(double dt) noexcept override {
        const bool solid = field_.depth > 0;
        const double beside = solid ? kBeside * field_.width : 0, goal = phase_ % 2 == 0 ? beside : field_.width - beside;
        go_towards({goal, field_.height / 2, solid ? at_.z : -kPress}, field_.speed, dt);
        if (solid) press(dt);
        if (at_.x == goal) next();
    }
};

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
        constexpr double kLane = 12, kOffAxis = 5;  // mm
        const double way = lane_ % 2 == 0 ? -1 : 1;
        go_towards({lane_ == 0 ? -2 : kLane * lane_, at_.y + way * field_.speed, -kPress}, field_.speed, dt);
        const double help = force_.y * way;
        held_ = help < -kFelt ? 0.25 : std::max(0.0, held_ - dt);
        // Near the lower axis that one helps.
        if (help > 2 * kFelt && held_ == 0 && finger_.y < field_.height - kOffAxis) {
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
        way_ = {1, 0, 0};
        before_ = finger_;
        velocity_ = field_.speed * way_;
        next();
    }
    void follow(double dt) noexcept {
        // It pushes on along its way and gives in across it.
        constexpr double kGives = 0.05, kTurns = 0.12;  // s
        const Point3 lead = flat(at_ - finger_), along = dot(lead, way_) * way_;
        at_ = at_ - std::min(1.0, dt / kGives) * (lead - along) + field_.speed * dt * way_;
        at_.z = -kPress;
        // Lightly: who presses harder than the line pulls is through it before it is felt.
        constexpr double kLight = 2;  // mm, some 0.6 N at the default finger, of which friction takes a part
        const double ahead = dot(flat(at_ - finger_), way_);
        if (ahead > kLight) at_ = at_ - (ahead - kLight) * way_;
        const Point3 moved = 1 / std::max(dt, 1e-6) * flat(finger_ - before_);
        before_ = finger_;
        // Where it was some millimetres ago.
        if (flat_length(finger_ - past_) > 8) past_ = finger_ - 6.0 * unit(flat(finger_ - past_));
        velocity_ = velocity_ + std::min(1.0, dt / kTurns) * (moved - velocity_);
        if (flat_length(velocity_) > field_.speed / 4) way_ = unit(way_ + dt / kTurns * unit(velocity_));
        // What pulls it aside leads the way.
        const Point3 pull = flat(force_), aside = pull - dot(pull, way_) * way_;
        way_ = unit(way_ + 6 * dt * aside);
        stalled_ = flat_length(velocity_) < field_.speed / 6 ? stalled_ + dt : 0;
        free_ = flat_length(pull) == 0 ? free_ + dt : 0;
        // From where it stalled it would go back whence it came: that was the end.
        if (tries_ > 0 && dot(way_, came_by_) < -0.7 && flat_length(finger_ - stalled_at_) < 10) return end();
        if (stalled_ > 0.4) turn();
        if (free_ > 4) end();  // nothing has pulled for a long way: it is off the line
    }
    // If the line does not continue, this is a corner, where the hand tries both sides, or the end.
    void turn() noexcept {
        constexpr double kAngle = 1.2, kNear = 4;  // rad, mm
        if (flat_length(finger_ - stalled_at_) > kNear) {
            stalled_at_ = finger_;
            stalled_way_ = way_;
            came_by_ = unit(finger_ - past_);
            tries_ = 0;
        }
        if (tries_ == 2) return end();
        const double angle = tries_++ == 0 ? kAngle : -kAngle, c = std::cos(angle), s = std::sin(angle);
        way_ = {c * stalled_way_.x - s * stalled_way_.y, s * stalled_way_.x + c * stalled_way_.y, 0};
        velocity_ = field_.speed / 2 * way_;  // it means to go there
        stalled_ = 0;
    }
    void end() noexcept {
        find("end of the curve");
        next();
    }
    void go_down(double dt) noexcept {
        go_towards({at_.x, field_.height + 3, -kPress}, 2 * field_.speed, dt);
        if ((force_.y < -3 * kFelt && finger_.y > field_.height - 3) || in_phase_ > 6) next();
    }
    // To the left along the lower axis. A bump resists on its rising side; after the top the finger slips down, so the hand
    // turns, comes back slowly, and rests a quarter of a bump beyond the point of greatest resistance: on the top.
    void slide(double dt) noexcept {
        constexpr double kQuarter = 1.25, kPush = 0.25;  // mm, N
        const double way = over_ ? 1 : -1, against = -way * force_.x;
        go_towards({at_.x + way * field_.speed, field_.height + 2, -kPress}, field_.speed / (over_ ? 8 : 2), dt);
        if (against > strongest_) {
            strongest_ = against;
            top_ = finger_.x + way * kQuarter;
        } else if (strongest_ > kPush && against < kFelt) {
            strongest_ = 0;
            if (over_) return next();
            over_ = true;
            at_.x = finger_.x;
        }
        if (finger_.x < 2 || in_phase_ > 20) done_ = true;
    }
    void rest(double dt) noexcept {
        go_towards({top_, field_.height + 2, -kPress}, field_.speed / 8, dt);
        if (std::abs(at_.x - top_) > 1e-9) in_phase_ = 0;
        if (in_phase_ < 0.4) return;
        find("tick");
        next();
    }

    int lane_ = 0, tries_ = 0;
    double held_ = 0, stalled_ = 0, free_ = 0;
    Point3 way_{1, 0, 0}, velocity_, before_, stalled_at_{-100, 0, 0}, stalled_way_, came_by_, past_;
    double strongest_ = 0, top_ = 0;
    bool over_ = false;
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

class Sections final : public ScriptedHand {
public:
    using ScriptedHand::ScriptedHand;

private:
    void go(double dt) noexcept override {
        constexpr double kApart = 0.01;  // of a section, from one height that is taken down to the next
        if (phase_ > 3) {
            done_ = true;
            return;
        }
        // First above the beginning of a section, then along it, pressing: the hand stays below the finger.
        const bool across = phase_ < 2;
        const double length = across ? field_.width : field_.height;
        const Point3 begin =
            across ? Point3{kBeside * length, field_.height / 2, 0} : Point3{field_.width / 2, kBeside * length, 0};
        if (phase_ % 2 == 0) {
            const double over = field_.depth + 5;
            go_towards(at_.z < over && flat_length(at_ - begin) > 1 ? Point3{at_.x, at_.y, over} : Point3{begin.x, begin.y, over},
                       2 * field_.speed, dt);
            if (flat_length(at_ - begin) < 1e-9) {
                taken_ = 0;
                next();
            }
            return;
        }
        press(dt);
        if (force_.z > 2 * kFelt || in_phase_ > 2) {
            const double step = field_.speed * dt;
            (across ? at_.x : at_.y) += step;
            const double share = (across ? finger_.x : finger_.y) / length;
            if (share > taken_ + kApart) {
                find(across ? "height across" : "height down");
                taken_ = share;
            }
            if ((across ? at_.x : at_.y) > (1 - kBeside) * length) next();
        }
    }
    double taken_ = 0;
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
        {"to-and-fro", "moves through the middle, from side to side", false, make<ToAndFro>},
        {"trace", "finds a curve from the axes, follows it to its end and stops at a tick", true, make<Trace>},
        {"points", "sweeps the field in rows and notes where points are", true, make<Points>},
        {"sections", "follows a surface along two lines through its middle", false, make<Sections>},
        {"led", "lets itself be led to where its keys say", true, make<Led>},
    };
    return kHands;
}

}  // namespace tactics
