// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/simulated/line_walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tactics/haptics/simulated/scripted_hand.h"

namespace tactics {

namespace {

// Turns to try at a corner, degrees: the slightest first, to either side.
constexpr double kTurnsToTry[] = {60, -60, 110, -110, 150, -150};
constexpr double kApart = 1;        // mm between places that it remembers
constexpr double kAway = 16;        // mm from a corner: it has gone round it, or back
constexpr double kSamePlace = 2.5;  // mm
constexpr double kBeside = 3.2;     // mm: may be the same place, as a finger is on either side of a line, or one beside a needle
constexpr double kCornerNear = 4;   // mm: still at that corner
constexpr std::size_t kNearStart = 20;  // places: hardly farther than kAway

Point3 turned_by(const Point3& way, double degrees) {
    const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    return {c * way.x - s * way.y, s * way.x + c * way.y, 0};
}

}  // namespace

void LineWalk::begin(const Point3& finger, const Point3& way, double speed) noexcept {
    *this = {};
    finger_ = before_ = start_ = corner_ = flat(finger);
    way_ = came_by_ = way;
    speed_ = speed;
    velocity_ = speed * way;
}

LineWalk::State LineWalk::go(const Point3& finger, const Point3& force, double dt, Point3& at) noexcept {
    finger_ = flat(finger);
    if (returns_ > 0) {
        // Back to the corner, giving way to the line.
        returns_ -= dt;
        const Point3 back = way_back() - finger_;
        at = finger_ + std::min(4.0, 1 + flat_length(back)) * unit(back) + Point3{0, 0, -kPress};
        before_ = finger_;
        if (length_of(corner_ - finger_) > 1 && returns_ > 0) return State::walks;
        returns_ = 0;
        return try_next() ? State::walks : State::ended;
    }
    push_on(force, dt, at);
    // So near its beginning it comes past that on the way back, where it knows no places.
    past_start_ = past_start_ || (trying_ && placed_at_corner_ < kNearStart && length_of(corner_ - start_) > 2 * kSamePlace &&
                                  length_of(finger_ - start_) < kSamePlace);
    if (const double away = length_of(finger_ - corner_); trying_ && away > kAway) {
        // Where it is not sure, it goes as far again.
        const bool far = away > 2 * kAway;
        if (was_here(far ? kBeside : kSamePlace)) return returns_ = 3, State::walks;
        trying_ = !far && was_here(kBeside);
    }
    if (!trying_) remember();
    if (is_back()) return State::closed;
    if (free_ > 4) return corner_ = finger_, State::ended;  // nothing has pulled for a long way: it is off the line
    return stalled_ > 0.4 ? stop() : State::walks;
}

void LineWalk::push_on(const Point3& force, double dt, Point3& at) noexcept {
    // On along its way, giving in across it.
    constexpr double kGives = 0.05, kTurns = 0.12;  // s
    const Point3 lead = flat(at) - finger_, along = dot(lead, way_) * way_;
    at = at - std::min(1.0, dt / kGives) * (lead - along) + speed_ * dt * way_;
    at.z = -kPress;
    // Lightly: who presses harder than the line pulls is through it before it is felt.
    constexpr double kLight = 2;  // mm, some 0.6 N at the default finger, of which friction takes a part
    const double ahead = dot(flat(at) - finger_, way_);
    if (ahead > kLight) at = at - (ahead - kLight) * way_;
    const Point3 moved = 1 / std::max(dt, 1e-6) * (finger_ - before_);
    before_ = finger_;
    velocity_ = velocity_ + std::min(1.0, dt / kTurns) * (moved - velocity_);
    if (flat_length(velocity_) > speed_ / 4) way_ = unit(way_ + dt / kTurns * unit(velocity_));
    // What pulls it aside leads the way.
    const Point3 pull = flat(force), aside = pull - dot(pull, way_) * way_;
    way_ = unit(way_ + 6 * dt * aside);
    stalled_ = flat_length(velocity_) < speed_ / 6 ? stalled_ + dt : 0;
    free_ = flat_length(pull) == 0 ? free_ + dt : 0;
}

void LineWalk::remember() noexcept {
    if (placed_ > 0 && length_of(places_[(placed_ - 1) % places_.size()] - finger_) < kApart) return;
    places_[placed_++ % places_.size()] = finger_;
}

// It does not get on here.
LineWalk::State LineWalk::stop() noexcept {
    stalled_ = 0;
    if (trying_ && length_of(finger_ - corner_) > kCornerNear) {
        if (was_here(kSamePlace)) return returns_ = 3, State::walks;
        trying_ = false;
    }
    if (!trying_) {
        corner_ = finger_;
        placed_at_corner_ = placed_;
        constexpr std::size_t kStraight = 6;  // mm, of which it knows the direction
        if (placed_ > kStraight) came_by_ = unit(finger_ - places_[(placed_ - kStraight) % places_.size()]);
        tries_ = 0;
        trying_ = true;
        if (is_to_and_fro()) return State::ended;
    }
    return try_next() ? State::walks : State::ended;
}

// It has come to corners again and again, and found nothing else: the last one that was new is the end.
bool LineWalk::is_to_and_fro() noexcept {
    constexpr std::size_t kAgain = 3, kTooOften = 12;
    const auto is_here = [this](const Point3& at) { return length_of(at - corner_) < kCornerNear; };
    if (std::none_of(corners_.begin(), corners_.begin() + static_cast<std::ptrdiff_t>(std::min(cornered_, corners_.size())),
                     is_here)) {
        corners_[cornered_++ % corners_.size()] = corner_;
        again_ = 0;
        return false;
    }
    ++again_;
    return again_ >= kTooOften || (again_ >= kAgain && is_here(corners_[(cornered_ - 1) % corners_.size()]));
}

bool LineWalk::try_next() noexcept {
    if (tries_ == std::size(kTurnsToTry)) return false;
    way_ = turned_by(came_by_, kTurnsToTry[tries_++]);
    velocity_ = speed_ / 2 * way_;  // it means to go there
    stalled_ = free_ = 0;
    past_start_ = false;
    return true;
}

// On the way by which it came to the corner.
bool LineWalk::was_here(double within) const noexcept {
    if (past_start_) return true;
    const std::size_t known = std::min(placed_at_corner_, places_.size());
    for (std::size_t back = 3; back <= known; ++back)
        if (length_of(places_[(placed_at_corner_ - back) % places_.size()] - finger_) < within) return true;
    return false;
}

// A few places farther towards the corner than the nearest that it knows: straight to it a line on the way might hold the finger.
Point3 LineWalk::way_back() const noexcept {
    constexpr std::size_t kAhead = 4;
    const auto place = [this](std::size_t back) { return places_[(placed_at_corner_ - back) % places_.size()]; };
    std::size_t nearest = 0;
    for (std::size_t back = 1; back <= std::min(placed_at_corner_, places_.size()); ++back)
        if (nearest == 0 || length_of(place(back) - finger_) < length_of(place(nearest) - finger_)) nearest = back;
    return nearest > kAhead ? place(nearest - kAhead) : corner_;
}

bool LineWalk::is_back() noexcept {
    constexpr double kNear = 3, kFar = 10;  // mm
    const double away = length_of(finger_ - start_);
    if (!left_ && away > kFar) {
        left_ = true;
        start_way_ = unit(finger_ - start_);
    }
    return left_ && away < kNear && !trying_ && dot(way_, start_way_) > 0.5;
}

}  // namespace tactics
