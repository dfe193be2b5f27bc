// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/sensing/odometry.h"

#include <algorithm>
#include <numbers>

namespace tactics {

namespace {

constexpr double kFastestMouse = 10'000;  // mm/s: no optical sensor follows a mouse that fast, and no hand moves it so
constexpr double kLeastPassed = 1e-3;     // s: steps may come in bundles
constexpr int kMostDisordered = 4;        // stamps out of order in a row: then it is the clock that has changed

// True: a stamp that is to be taken. `out_of_order` counts those that were not, -1 before the first.
bool in_order(double stamp, double& time, int& out_of_order, bool& restarted) {
    restarted = false;
    if (!(std::abs(stamp) < 1e12)) return false;
    if (out_of_order >= 0 && stamp <= time) {
        // A repeat is no sign of another clock.
        if (stamp == time || ++out_of_order < kMostDisordered) return false;
        restarted = true;
    }
    time = stamp;
    out_of_order = 0;
    return true;
}

}  // namespace

Odometry::Odometry(const MouseGeometry& geometry)
    : apart_(std::abs(geometry.sensors_apart) > 1e-3 && std::abs(geometry.sensors_apart) < 1e6 ? geometry.sensors_apart
                                                                                               : MouseGeometry{}.sensors_apart),
      finger_(is_place(geometry.finger) ? geometry.finger : Point{}) {}

bool Odometry::takes(const OpticalStep& step, double& passed, bool& restarted) noexcept {
    const double before = time_;
    const bool first = out_of_order_ < 0;
    restarted = false;
    if (!is_place(step.first) || !is_place(step.second) || !in_order(step.time, time_, out_of_order_, restarted)) return false;
    passed = first || restarted ? kLeastPassed : time_ - before;
    const double most = kFastestMouse * std::max(passed, kLeastPassed);
    return distance({}, step.first) < most && distance({}, step.second) < most;
}

FingerStep Odometry::advance(Point first, Point second) noexcept {
    const double turn = std::clamp((second.y - first.y) / apart_, -1.0, 1.0), half = turn / 2;
    const double chord = std::abs(half) < 1e-9 ? 1 : std::sin(half) / half;
    const double c = std::cos(heading_ + half) * chord, s = std::sin(heading_ + half) * chord;
    const Point middle{(first.x + second.x) / 2, (first.y + second.y) / 2}, arm{-turn * finger_.y, turn * finger_.x};
    heading_ = std::remainder(heading_ + turn, 2 * std::numbers::pi);
    return {{c * middle.x - s * middle.y, s * middle.x + c * middle.y}, {c * arm.x - s * arm.y, s * arm.x + c * arm.y}, turn};
}

bool SampleOrder::takes(const OverlaySample& sample) noexcept {
    bool restarted = false;
    return is_place(sample.at) && in_order(sample.time, time_, out_of_order_, restarted);
}

}  // namespace tactics
