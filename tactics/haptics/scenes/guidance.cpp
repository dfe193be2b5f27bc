// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/guidance.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactics {

namespace {

constexpr double kSpeed = 40;        // mm/s
constexpr double kLeastAhead = 1.6;  // mm at the greatest force
constexpr double kLeaves = 5;        // mm beyond that
constexpr double kPatience = 1;      // s
constexpr double kSoft = 0.3;        // s
constexpr double kArrived = 0.3;     // mm
constexpr double kRest = 0.1;        // s that it stays there, while the hand comes after
constexpr double kTurnsIn = 1;       // mm from a curve that it is carried to: from here it goes along
constexpr double kThere = 2;         // mm from a place that it was led to before: it is there still
constexpr double kAtEnd = 1;         // mm from the end of a curve along it
constexpr std::size_t kMostRecords = 1024;

Point flat(const Point3& place) noexcept { return {place.x, place.y}; }
Point3 solid(Point place) noexcept { return {place.x, place.y, 0}; }
// A finger is not drawn out of the wall.
Point3 above_plane(const Point3& finger) noexcept { return {finger.x, finger.y, std::max(0.0, finger.z)}; }

}  // namespace

GuidanceSettings guidance_for(double most_force, double stiffness, double damping_ns_per_m) {
    const double force = std::min(1.0, most_force / 4);
    return {force, std::min(stiffness, force / kLeastAhead), damping_ns_per_m};
}

Guidance::Guidance(Scene& scene, GuidedLines lines, const PlotFrame& frame, const GuidanceSettings& settings)
    : scene_(scene), lines_(std::move(lines)), frame_(frame), settings_(settings) {
    records_.reserve(kMostRecords);
}

std::optional<LeadGoal> Guidance::lead(LeadTo lead, const Point3& finger, const Nearness& near) noexcept {
    const bool again = leading_ && goal_.lead == lead;
    if (lines_.empty() || !is_finite(finger)) {
        end(LeadEnd::stopped);
        return std::nullopt;
    }
    // A repeated request continues from the leading point, regardless of curves that cross there.
    const LinePlace here = again ? on_ : near.within ? lines_.place_of(near) : lines_.roughly_nearest(flat(finger));
    end(LeadEnd::stopped);
    goal_ = {lead, lines_.curve_of(here.line), 0, {}, false, {}};
    const bool found = lead == LeadTo::start      ? to_start(again, flat(finger))
                       : lead == LeadTo::follow   ? to_end(here, again)
                       : lead == LeadTo::extremum ? to_turn(here, again, flat(finger))
                                                  : to_other(here);
    if (!found) return std::nullopt;
    goal_.place = lines_.at(stop_);
    if (lead != LeadTo::extremum) {
        const Point3 value = frame_.values(solid(goal_.place));
        goal_.value = {value.x, value.y};
    }
    leading_ = carries_ = true;
    follows_ = lead == LeadTo::follow || lead == LeadTo::extremum;
    on_ = follows_ ? here : stop_;
    speed_ = kSpeed * lines_.winding(goal_.curve);
    finger_ = ahead_ = above_plane(finger);
    waited_ = rested_ = soft_ = more_ = 0;
    begun_ = ticks_;
    return goal_;
}

bool Guidance::to_start(bool again, Point finger) noexcept {
    std::size_t curve = goal_.curve;
    const auto begins_at = [&](std::size_t one) { return lines_.at({lines_.first_line(one), 0}); };
    const std::size_t last = last_start_.value_or(curve);
    if (again || distance(begins_at(last), finger) < kThere) {
        curve = last;
        do curve = (curve + 1) % lines_.curves();
        while (!lines_.has_place(curve));
    }
    goal_.curve = static_cast<std::uint32_t>(curve);
    last_start_ = curve;
    stop_ = {lines_.first_line(curve), 0};
    forward_ = true;
    return true;
}

bool Guidance::to_end(const LinePlace& here, bool again) noexcept {
    const std::uint32_t first = lines_.first_line(goal_.curve), last = lines_.end_line(goal_.curve) - 1;
    if (again) forward_ = !forward_;
    // From an end there is one way only.
    if (here.line == last && here.along > lines_.length(last) - kAtEnd) forward_ = false;
    if (here.line == first && here.along < kAtEnd) forward_ = true;
    stop_ = end_of(forward_ ? last : first, forward_);
    return true;
}

bool Guidance::to_turn(const LinePlace& here, bool again, Point finger) noexcept {
    // A finger that is a little before the turn that it was led to is not led there again.
    const bool is_there = last_turn_ && lines_.curve_of(last_turn_->line) == goal_.curve &&
                          (again || distance(lines_.at(*last_turn_), finger) < kThere);
    const CurveTurn* turn = lines_.next_turn(is_there ? *last_turn_ : here, forward_);
    if (turn == nullptr) {
        forward_ = !forward_;
        return false;
    }
    goal_.highest = turn->highest;
    goal_.value = turn->value;
    last_turn_ = stop_ = turn->at;
    return true;
}

bool Guidance::to_other(const LinePlace& here) noexcept {
    const double x = lines_.at(here).x;
    goal_.from = goal_.curve;
    for (std::size_t step = 1; step < lines_.curves(); ++step) {
        const std::size_t curve = (goal_.from + step) % lines_.curves();
        const auto there = lines_.has_place(curve) ? lines_.first_at(curve, x) : std::nullopt;
        if (!there) continue;
        goal_.curve = static_cast<std::uint32_t>(curve);
        stop_ = *there;
        return true;
    }
    return false;
}

std::optional<LeadRecord> Guidance::ended() noexcept {
    if (told_ || records_.empty()) return std::nullopt;
    told_ = true;
    return records_.back();
}

void Guidance::end(LeadEnd how) noexcept {
    if (!leading_) return;
    leading_ = false;
    if (records_.size() == kMostRecords) records_.erase(records_.begin());
    records_.push_back({goal_, how, begun_, ticks_, length_of(finger_ - solid(goal_.place))});
    told_ = how == LeadEnd::stopped;
}

// Moves the leading point by that distance, mm, at most to the end of its path. false: it has arrived and waits for the finger.
bool Guidance::advance(double way) noexcept {
    if (carries_) {
        const Point3 goal = solid(lines_.middle_at(on_, stop_)), rest = goal - ahead_;
        const double length = length_of(rest);
        ahead_ = length > way ? ahead_ + way / length * rest : goal;
        if (ahead_ == goal && follows_ && length_of(goal - finger_) < kTurnsIn) carries_ = false;
        return length > 0 || !carries_;
    }
    const LinePlace until = on_.line == stop_.line ? stop_ : end_of(on_.line, forward_);
    on_.along = forward_ ? std::min(on_.along + way, until.along) : std::max(on_.along - way, until.along);
    ahead_ = solid(lines_.middle_at(on_, stop_));
    if (on_.line != stop_.line && on_.along == until.along) {
        // Over a gap.
        on_ = end_of(forward_ ? on_.line + 1 : on_.line - 1, !forward_);
        carries_ = true;
    }
    return true;
}

Point3 Guidance::led(const Touch& touch, double dt) noexcept {
    if (!is_finite(touch.finger) || !is_finite(touch.velocity)) {
        end(LeadEnd::left);
        return {};
    }
    finger_ = above_plane(touch.finger);
    ahead_.z = std::min(ahead_.z, finger_.z);  // a finger that moves down on its own is not held up
    soft_ = std::min(1.0, soft_ + dt / kSoft);
    const double reach = settings_.most_force / settings_.stiffness;
    const double away = length_of(ahead_ - finger_);
    if (away > reach + kLeaves) {
        end(LeadEnd::left);
        return {};
    }
    const Point3 last = solid(goal_.place);
    const bool at_goal = ahead_ == last && on_ == stop_;
    if (at_goal && away < kArrived) {
        rested_ += dt;
        if (rested_ >= kRest) {
            end(LeadEnd::arrived);
            return {};
        }
    } else {
        rested_ = 0;
    }
    const double more = dt / kPatience * settings_.most_force;
    if (!at_goal && away < reach && advance((carries_ ? kSpeed : speed_) * dt)) {
        waited_ = 0;
        more_ = std::max(0.0, more_ - more);
    } else if (away >= kArrived) {
        waited_ += dt;
        more_ = std::min(settings_.most_force, more_ + more);
        if (waited_ > kPatience) {
            end(LeadEnd::resisted);
            return {};
        }
    }
    const Point3 way = ahead_ - finger_;
    const double length = length_of(way);
    if (!(length > 0)) return {};
    const double pulled = std::min(settings_.most_force, soft_ * (settings_.stiffness * length + more_));
    const Point3 force = pulled / length * way - settings_.damping_ns_per_m / 1000 * touch.velocity;
    Point3 bounded = within(force, settings_.most_force);
    // On the plane it is the wall that bears it.
    if (touch.finger.z <= 0) bounded.z = 0;
    return bounded;
}

Felt Guidance::feel(const Touch& touch, double dt) noexcept {
    Felt felt = scene_.feel(touch, dt);
    ++ticks_;
    if (!(dt >= 0)) dt = 0;
    const double step = dt / kSoft;
    gone_ = leading_ && carries_ ? std::min(1.0, gone_ + step) : std::max(0.0, gone_ - step);
    felt.force.x *= 1 - gone_;
    felt.force.y *= 1 - gone_;
    if (leading_) felt.force = felt.force + led(touch, dt);
    return felt;
}

void Guidance::begin_again() noexcept {
    end(LeadEnd::stopped);
    gone_ = 0;
    scene_.begin_again();
}

}  // namespace tactics
