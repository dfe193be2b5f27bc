// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "tactics/haptics/simulated/scripted_hand.h"

namespace tactics {

namespace {

constexpr double kNoted = 0.01;  // of a section, from one height that is noted to the next
constexpr double kOver = 5;      // mm above all that there is: the finger touches nothing
constexpr double kHeldUp = 6;    // mm that the hand is ahead of a finger that is held up, as by a wall
constexpr double kStill = 0.5;   // s without getting on
constexpr double kStride = 1;    // mm: less is not getting on
constexpr double kPast = 6;      // mm farther on, where it sets down again
constexpr double kFoot = 1.5;    // mm: deeper than a finger sinks into a surface
constexpr double kGivesUp = 4;   // s

class Sections final : public ScriptedHand {
public:
    using ScriptedHand::ScriptedHand;

private:
    enum class Way { begins, presses, lifts, passes };

    void go(double dt) noexcept override {
        switch (way_) {
            case Way::begins: return begin(dt);
            case Way::presses: return press_on(dt);
            case Way::lifts: return lift(dt);
            case Way::passes: return pass(dt);
        }
    }

    double length() const { return across_ ? field_.width : field_.height; }
    double end() const { return (1 - kBesideSolid) * length(); }
    double over() const { return field_.depth + kOver; }
    double along(const Point3& at) const { return across_ ? at.x : at.y; }
    Point3 on_line(double at, double z, double aside = 0) const {
        return across_ ? Point3{at, field_.height / 2 + aside, z} : Point3{field_.width / 2 + aside, at, z};
    }
    void turn_to(Way way) noexcept { way_ = way, in_phase_ = on_ground_ = 0; }

    // Up, and down at the beginning of a section.
    void begin(double dt) noexcept {
        const Point3 there = on_line(kBesideSolid * length(), over());
        constexpr double kArrived = 2;  // mm: friction may hold the finger that far off
        const bool up = finger_.z < over() - kArrived && flat_length(at_ - there) > 1;
        go_towards(up ? Point3{at_.x, at_.y, over()} : there, 2 * field_.speed, dt);
        done_ = in_phase_ > 2 * kGivesUp + 2 * length() / field_.speed;
        if (length_of(finger_ - there) > kArrived || length_of(at_ - there) > 1e-9) return;
        noted_ = aside_ = 0;
        furthest_ = along(at_);
        turn_to(Way::presses);
    }

    // Along the line, pressing: the hand stays below the finger, and leads it back to the line from which it slides, as from the
    // tip of a cone. It slows where it hardly feels ground. Where it is held up, it climbs; where it gets on no more, or there is
    // no ground, it lifts the finger and sets it down beyond.
    void press_on(double dt) noexcept {
        constexpr double kSure = 0.3, kLeads = 0.15, kMostAside = 6, kAside = 4, kLands = 1,
                         kOnLine = 0.3;  // N, s, mm, mm, s, mm
        const double felt = length_of(force_), off = across_ ? field_.height / 2 - finger_.y : field_.width / 2 - finger_.x;
        aside_ = std::clamp(aside_ + dt / kLeads * off, -kMostAside, kMostAside);
        double z = at_.z + field_.speed / 2 * dt;
        if (along(at_) - along(finger_) <= kHeldUp) press(dt), z = at_.z;
        // First of all it brings the finger onto the line.
        on_ground_ = felt > 0 ? on_ground_ + dt : on_ground_;
        const bool lands = felt > 0 && on_ground_ < kLands && std::abs(off) > kOnLine;
        const double sure = lands ? 0.0 : std::min(1.0, felt / kSure) * std::clamp(1 - std::abs(off) / kAside, 0.2, 1.0);
        at_ = on_line(along(at_) + sure * field_.speed * dt, z, aside_);
        if (!lands) note();
        const double before = furthest_;
        if (along(finger_) > furthest_ + kStride) furthest_ = along(finger_);
        const bool falls = lands || (felt == 0 && finger_.z > -kFoot);
        if (furthest_ > before || falls) in_phase_ = 0;
        if (along(felt_at_) > end()) return finish();
        if (in_phase_ > kStill) turn_to(Way::lifts);
    }

    void note() noexcept {
        const bool ground = force_.z > kFelt / 2, none = length_of(force_) == 0 && felt_at_.z < -kFoot && finger_.z < -kFoot;
        const double share = along(felt_at_) / length();
        if (!(ground || none) || share < noted_ + kNoted) return;
        noted_ = share;
        find(ground ? across_ ? "height across" : "height down" : across_ ? "no ground across" : "no ground down", felt_at_);
    }

    // Straight up; where that is barred, as under the edge of a hole, somewhat back.
    void lift(double dt) noexcept {
        const bool barred = force_.z < -2 * kFelt;
        go_towards(on_line(furthest_ - (barred ? kPast : 0), barred ? finger_.z - 1 : over()), field_.speed, dt);
        if (finger_.z > over() - 2) return turn_to(Way::passes);
        if (in_phase_ > kGivesUp + over() / field_.speed) give_up();
    }

    void pass(double dt) noexcept {
        const double beyond = std::min(end(), furthest_ + kPast);
        go_towards(on_line(beyond, over()), field_.speed, dt);
        if (along(finger_) < beyond - kStride) {
            if (in_phase_ > kGivesUp) give_up();
            return;
        }
        furthest_ = beyond;
        if (furthest_ >= end()) return finish();
        turn_to(Way::presses);
    }

    void give_up() noexcept {
        find("stuck");
        finish();
    }
    void finish() noexcept {
        if (!across_) done_ = true;
        across_ = false;
        turn_to(Way::begins);
    }

    Way way_ = Way::begins;
    bool across_ = true;
    double noted_ = 0, furthest_ = 0, aside_ = 0, on_ground_ = 0;  // a share of the section, mm, mm, s
};

}  // namespace

std::unique_ptr<Hand> sections_hand(const HandField& field) { return std::make_unique<Sections>(field); }

}  // namespace tactics
