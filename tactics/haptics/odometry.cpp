#include "tactics/haptics/odometry.h"

#include <algorithm>

namespace tactics {

namespace {

constexpr double kFastest = 10'000;      // mm/s: no optical sensor follows a mouse that fast, and no hand moves it so
constexpr double kLeastPassed = 1e-3;    // s: steps may come in bundles
constexpr int kPatience = 4;             // stamps out of order in a row: then it is the clock that has changed

// True: a stamp that is to be taken. `out_of_order` counts those that were not, -1 before the first.
bool in_order(double stamp, double& time, int& out_of_order, bool& restarted) {
    restarted = false;
    if (!(std::abs(stamp) < 1e12)) return false;
    if (out_of_order >= 0 && stamp <= time) {
        // A repeat is no sign of another clock.
        if (stamp == time || ++out_of_order < kPatience) return false;
        restarted = true;
    }
    time = stamp;
    out_of_order = 0;
    return true;
}

}  // namespace

Odometry::Odometry(const MouseGeometry& geometry)
    : apart_(std::abs(geometry.sensors_apart) > 1e-3 && std::abs(geometry.sensors_apart) < 1e6 ? geometry.sensors_apart : MouseGeometry{}.sensors_apart),
      finger_(is_place(geometry.finger) ? geometry.finger : Point{}) {}

bool Odometry::advance(const OpticalStep& step, FingerStep& finger, bool& restarted) noexcept {
    const double before = time_;
    const bool first = out_of_order_ < 0;
    if (!is_place(step.first) || !is_place(step.second)) {
        restarted = false;
        return false;
    }
    if (!in_order(step.time, time_, out_of_order_, restarted)) return false;
    finger.passed = first || restarted ? kLeastPassed : time_ - before;
    const double most = kFastest * std::max(finger.passed, kLeastPassed);
    const double turn = (step.second.y - step.first.y) / apart_;
    Point moved{(step.first.x + step.second.x) / 2, (step.first.y + step.second.y) / 2};
    if (distance({}, moved) > most || std::abs(turn) > 1) {
        finger.moved = {};
        finger.turned = finger.across = 0;
        return true;  // its time is good
    }
    finger.across = moved.y;
    moved.x -= turn * finger_.y;
    moved.y += turn * finger_.x;
    const double half = turn / 2;
    const double chord = std::abs(half) < 1e-9 ? 1 : std::sin(half) / half;
    const Point straight = tactics::turned(moved, heading_ + half);
    finger.moved = {straight.x * chord, straight.y * chord};
    finger.turned = turn;
    heading_ += turn;
    return true;
}

bool SampleOrder::takes(const OverlaySample& sample) noexcept {
    bool restarted = false;
    return is_place(sample.at) && in_order(sample.time, time_, out_of_order_, restarted);
}

}  // namespace tactics
