// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/spoken_scene.h"

#include <cmath>

namespace tactics {

namespace {

constexpr double kOnCurve = 2;   // mm from a curve: it is under the finger
constexpr double kOnAxis = 1;    // mm before an axis
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

SpokenScene::SpokenScene(Scene& scene, Speaking& speaking, const PlotFrame& frame, const FeltLines& lines)
    : scene_(scene), speaking_(speaking), frame_(frame), lines_(lines.lines, {}), curves_(lines.curve) {}

void SpokenScene::look_under(const Point3& finger, Announcement& one) const noexcept {
    const Nearness near = lines_.at(finger);
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
    else if (across.away < kOnAxis)
        one.felt = FeltPart::x_grid;
    else if (down.away < kOnAxis)
        one.felt = FeltPart::y_grid;
    if (one.felt == FeltPart::x_tick || one.felt == FeltPart::x_grid) one.x = across.value;
    if (one.felt == FeltPart::y_tick || one.felt == FeltPart::y_grid) one.y = down.value;
}

Announcement SpokenScene::announcement_for(unsigned key, const Point3& finger) const noexcept {
    const Point3 values = frame_.values(finger);
    Announcement one;
    one.x = values.x;
    one.y = values.y;
    if (frame_.depth > 0) one.z = values.z;
    one.telling = key == 0 ? Telling::position : key == 1 ? Telling::nearest : Telling::under_finger;
    if (one.telling == Telling::under_finger) look_under(finger, one);
    return one;
}

Felt SpokenScene::feel(const Touch& touch, double dt) noexcept {
    constexpr unsigned kKeys = 3;
    for (unsigned key = 0; key < kKeys; ++key)
        if ((touch.keys >> key & 1) != 0 && (down_ >> key & 1) == 0) speaking_.ask(announcement_for(key, touch.finger));
    down_ = touch.keys;
    return scene_.feel(touch, dt);
}

}  // namespace tactics
