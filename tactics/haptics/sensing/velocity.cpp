// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/sensing/velocity.h"

#include <algorithm>
#include <cmath>

#include "tactics/haptics/sensing/odometry.h"

namespace tactics {

namespace {

constexpr double kOfLate = 0.02;    // s, over which second differences are averaged
constexpr double kShare = 3;        // of that a place may lie off its course
constexpr double kLeastOff = 1e-4;  // mm: finer than any sensor counts

}  // namespace

// Every place between the ends is near the line from end to end, each at its time.
bool AdaptiveVelocity::is_straight(std::size_t ticks) const noexcept {
    const Moment &end = past(0), &begin = past(ticks);
    const double most = std::max(kLeastOff, kShare * uneven_), whole = end.time - begin.time;
    for (std::size_t ago = 1; ago < ticks; ++ago) {
        const Moment& middle = past(ago);
        const double share = (middle.time - begin.time) / whole;
        const double x = begin.at.x + share * (end.at.x - begin.at.x) - middle.at.x;
        const double y = begin.at.y + share * (end.at.y - begin.at.y) - middle.at.y;
        if (!(x * x + y * y <= most * most)) return false;
    }
    return true;
}

void AdaptiveVelocity::step(Point moved, double dt) noexcept {
    if (!(dt > 0) || !std::isfinite(dt) || !is_place(moved)) return;
    const Moment before = past(0);
    last_ = (last_ + 1) % moments_.size();
    if (count_ == moments_.size()) uneven_ += (past(0).uneven - uneven_) * std::min(1.0, dt / kOfLate);
    count_ = std::min(count_ + 1, moments_.size());
    Moment& now = moments_[last_];
    now = {before.time + dt, {before.at.x + moved.x, before.at.y + moved.y}};
    if (count_ > 2) {
        const double share = dt / (before.time - past(2).time);
        now.uneven = distance({share * (before.at.x - past(2).at.x), share * (before.at.y - past(2).at.y)}, moved);
    }
    for (std::size_t ticks = 1; ticks < count_ && is_straight(ticks); ++ticks) {
        const Moment& begin = past(ticks);
        const double time = past(0).time - begin.time;
        velocity_ = {(past(0).at.x - begin.at.x) / time, (past(0).at.y - begin.at.y) / time};
        doubt_ = kShare * uneven_ / time;
        if (ticks > 1 || count_ == 2) continue;
        // For one tick, it is the mean half a tick ago; a braking hand is slower by now.
        const double earlier = begin.time - past(2).time;
        const Point was{(begin.at.x - past(2).at.x) / earlier, (begin.at.y - past(2).at.y) / earlier};
        const Point slower{1.5 * velocity_.x - 0.5 * was.x, 1.5 * velocity_.y - 0.5 * was.y};
        if (distance({}, slower) < distance({}, velocity_)) velocity_ = slower;
    }
}

}  // namespace tactics
