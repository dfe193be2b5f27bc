// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/keyed_scene.h"

#include <algorithm>
#include <cmath>

#include "tactics/haptics/voice/surface_place.h"

namespace tactics {

namespace {

constexpr double kOnCurve = 2;   // mm from a curve: it is under the finger
constexpr double kOnAxis = 1;    // mm before an axis
constexpr double kPressed = 8;   // mm that a finger sinks into what it presses on: 4 N into the 0.5 N/mm of an Omni
constexpr double kOnTick = 2.5;  // mm from a tick or a grid line, half of a bump

// The value of the nearest tick and how far it is, mm.
struct NearTick {
    double value = 0, away = INFINITY;
};
template <typename At>
NearTick nearest_tick(const FeltAxis& axis, At at, double place) noexcept {
    NearTick best;
    for (const double tick : axis.ticks)
        if (const double away = std::abs(at(tick) - place); away < best.away) best = {tick, away};
    return best;
}

}  // namespace

KeyedScene::KeyedScene(Guidance& guidance, const KeyedParts& parts, const PlotFrame& frame, const FeltLines& lines)
    : guidance_(guidance), parts_(parts), frame_(frame), lines_(lines.lines), curves_(lines.curve) {}

void KeyedScene::look_under(const Point3& finger, const Nearness& near, Announcement& one) const noexcept {
    if (near.within && near.distance < kOnCurve) {
        one.felt = FeltPart::curve;
        one.series = static_cast<std::uint32_t>(curves_[near.line]);
        return;
    }
    const NearTick across = nearest_tick(
        frame_.x, [&](double tick) { return frame_.across(tick); }, finger.x);
    const NearTick down = nearest_tick(
        frame_.y, [&](double tick) { return frame_.down(tick); }, finger.y);
    const bool below = finger.y > frame_.height - kOnAxis, left = finger.x < kOnAxis;
    if (below)
        one.felt = across.away < kOnTick ? FeltPart::x_tick : FeltPart::x_axis;
    else if (left)
        one.felt = down.away < kOnTick ? FeltPart::y_tick : FeltPart::y_axis;
    else if (is_on_surface(finger))
        one.felt = FeltPart::surface;
    else if (across.away < kOnAxis)
        one.felt = FeltPart::x_grid;
    else if (down.away < kOnAxis)
        one.felt = FeltPart::y_grid;
    if (one.felt == FeltPart::x_tick || one.felt == FeltPart::x_grid) one.x = across.value;
    if (one.felt == FeltPart::y_tick || one.felt == FeltPart::y_grid) one.y = down.value;
}

bool KeyedScene::is_on_surface(const Point3& finger) const noexcept {
    if (parts_.surface == nullptr || !(frame_.depth > 0)) return false;
    const Point3 values = frame_.values(finger);
    const double height = frame_.depth * frame_.z.share_of(place_on(*parts_.surface, values.x, values.y).height);
    return finger.z < height + kOnCurve && finger.z > height - kPressed;  // false where it is not known
}

void KeyedScene::tell(Telling telling, const Point3& finger, const Nearness& near) noexcept {
    const Point3 values = frame_.values(finger);
    Announcement one{.telling = telling, .x = values.x, .y = values.y};
    if (frame_.depth > 0) one.z = values.z;
    if (telling == Telling::under_finger) look_under(finger, near, one);
    ask(one);
}

void KeyedScene::lead(LeadTo where, const Point3& finger, const Nearness& near) noexcept {
    const auto goal = guidance_.lead(where, finger, near);
    if (!goal) {
        const bool has_none = near.within && guidance_.lines().turns(curves_[near.line]).empty();
        ask({.telling = guidance_.lines().empty()   ? Telling::no_curve
                        : where != LeadTo::extremum ? Telling::no_other_curve
                        : has_none                  ? Telling::no_turns
                                                    : Telling::no_turn});
    } else if (where == LeadTo::compare) {
        ask({.telling = Telling::comparison, .series = goal->from, .other = goal->curve, .x = goal->value.x});
    }
}

void KeyedScene::tell_end(const LeadRecord& record) noexcept {
    const LeadGoal& goal = record.goal;
    Announcement one{.telling = Telling::let_go, .series = goal.curve, .x = goal.value.x, .y = goal.value.y};
    if (record.end == LeadEnd::arrived) {
        if (goal.lead == LeadTo::compare) return;
        one.telling = goal.lead == LeadTo::extremum ? (goal.highest ? Telling::maximum : Telling::minimum) : Telling::way_end;
    }
    ask(one);
}

void KeyedScene::act(PlotAction action, const Point3& finger, const Nearness& near) noexcept {
    const auto actions = chosen_actions();
    switch (action) {
        case PlotAction::chosen: return act(actions[chosen_], finger, near);
        case PlotAction::choose:
            if (guidance_.is_leading()) return act(PlotAction::let_go, finger, near);
            chosen_ = (chosen_ + 1) % actions.size();
            return ask({.telling = Telling::choice, .action = actions[chosen_]});
        case PlotAction::position: return tell(Telling::position, finger, near);
        case PlotAction::nearest: return tell(Telling::nearest, finger, near);
        case PlotAction::under: return tell(Telling::under_finger, finger, near);
        case PlotAction::start: return lead(LeadTo::start, finger, near);
        case PlotAction::follow: return lead(LeadTo::follow, finger, near);
        case PlotAction::extremum: return lead(LeadTo::extremum, finger, near);
        case PlotAction::compare: return lead(LeadTo::compare, finger, near);
        case PlotAction::let_go:
            if (!guidance_.is_leading()) return;
            guidance_.let_go();
            ask({.telling = Telling::let_go});
    }
}

void KeyedScene::sound(const Nearness& near, double dt) noexcept {
    Tone tone;
    if (near.within && near.distance < kOnCurve)
        tone = {1 - near.place.y / frame_.height, near.place.x / frame_.width, static_cast<std::uint8_t>(curves_[near.line]),
                true};
    if (parts_.toning != nullptr) parts_.toning->tell(tone);
    if (parts_.track != nullptr) parts_.track->add(tone, dt);
}

Felt KeyedScene::feel(const Touch& touch, double dt) noexcept {
    const unsigned asked = touch.keys & ~down_;
    down_ = touch.keys;
    const std::uint64_t typed = parts_.typed != nullptr ? parts_.typed->take() : 0;
    const bool sounds = parts_.toning != nullptr || parts_.track != nullptr;
    if (asked != 0 || typed != 0 || sounds) {
        const Nearness near = lines_.at(touch.finger);
        for (std::size_t key = 0; key < kNumberedKeys; ++key)
            if ((asked >> key & 1) != 0) act(plot_keys()[key].action, touch.finger, near);
        for (int at = 64 - TypedKeys::kBits; typed != 0 && at >= 0; at -= TypedKeys::kBits)
            if (const std::size_t entry = typed >> at & 0xF; entry > 0) act(plot_keys()[entry - 1].action, touch.finger, near);
        if (sounds) sound(near, dt);
    }
    const Felt felt = guidance_.feel(touch, dt);
    if (const auto ended = guidance_.ended()) tell_end(*ended);
    return felt;
}

}  // namespace tactics
