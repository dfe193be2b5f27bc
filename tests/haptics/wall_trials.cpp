// SPDX-License-Identifier: Apache-2.0
#include "tests/haptics/wall_trials.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactics {

namespace {

constexpr double kBefore = 8;      // mm that the hand moves before the edge, or before it stops
constexpr double kAfter = 0.6;     // s
constexpr double kBraking = 2500;  // mm/s2
constexpr int kLooks = 10;         // within a tick

// In a height map a wall is as wide as its samples are apart.
double wall_height(const void* wide, Point at) noexcept {
    const double width = *static_cast<const double*>(wide);
    return at.x < -width / 2 ? kFloor : at.x >= width / 2 ? kWallTop : kFloor + (kWallTop - kFloor) * (at.x / width + 0.5);
}

// One tick after the other; `see(x, time, height)` within each.
template <typename Speed, typename See>
void drive(const WallSettings& settings, const FingerSettings& finger, double wide, double from, double seconds,
           const Speed& speed_at, const See& see) {
    SimulatedLever lever(settings.lever, finger, kFloor - hangs(settings));
    Wall wall(settings);
    const double dt = 1 / settings.lever.rate_hz;
    double x = from, before = lever.height();
    for (double time = 0; time < seconds;) {
        const double height = lever.height();
        const double reference = wall.reference({&wide, wall_height}, {x, 0}, {speed_at(x), 0}, dt);
        lever.push(wall_force(settings, wall, reference, height, before, dt));
        before = height;
        for (int look = 0; look < kLooks; ++look) {
            lever.advance(dt / kLooks);
            x += speed_at(x) * dt / kLooks;
            time += dt / kLooks;
            see(x, time, lever.true_height());
        }
    }
}

}  // namespace

Crossing cross(const WallSettings& settings, const FingerSettings& finger, double speed, double wide) {
    WallSettings real = settings;
    real.finger = finger;
    const double rests = kWallTop - hangs(real);
    Crossing crossing;
    bool half = false;
    drive(
        settings, finger, wide, -kBefore, kBefore / speed + kAfter, [&](double) { return speed; },
        [&](double x, double time, double height) {
            crossing.overshoot = std::max(crossing.overshoot, height - kWallTop);
            if (!half && height >= (kFloor + kWallTop) / 2) {
                half = true;
                crossing.shift = x;
            }
            if (std::abs(height - rests) > 1) crossing.settled = time - kBefore / speed;
        });
    if (!half) crossing.shift = kAfter * speed;
    return crossing;
}

double false_bump(const WallSettings& settings, const FingerSettings& finger, double speed, double before, double wide) {
    before += wide / 2;
    const auto braked = [&](double x) { return std::min(speed, std::sqrt(std::max(0.0, 2 * kBraking * (-before - x)))); };
    double bump = 0;
    drive(settings, finger, wide, -before - kBefore, kBefore / speed + kAfter, braked,
          [&](double, double, double height) { bump = std::max(bump, height - kFloor); });
    return bump;
}

double highest_false_bump(const WallSettings& settings, const FingerSettings& finger, double speed, double nearest, double wide) {
    double bump = 0;
    for (int tenth = static_cast<int>(std::lround(nearest * 10)); tenth <= 20; ++tenth)
        bump = std::max(bump, false_bump(settings, finger, speed, tenth / 10.0, wide));
    return bump;
}

double turning_bump(const WallSettings& settings, const FingerSettings& finger, double speed, double radius, double before) {
    SimulatedLever lever(settings.lever, finger, kFloor - hangs(settings));
    Wall wall(settings);
    const double dt = 1 / settings.lever.rate_hz, wide = 0;
    double held = lever.height(), bump = 0;
    for (double way = -3 * kBefore; way < 3 * kBefore; way += speed * dt) {
        // To the right, then the quarter, then along the wall.
        const double angle = std::clamp(way / radius, 0.0, std::numbers::pi / 2),
                     on = std::max(0.0, way - radius * std::numbers::pi / 2);
        const Point at{-before - radius + std::min(way, 0.0) + radius * std::sin(angle), radius * (1 - std::cos(angle)) + on};
        const double height = lever.height();
        const double reference = wall.reference({&wide, wall_height}, at, {speed * std::cos(angle), speed * std::sin(angle)}, dt);
        lever.push(wall_force(settings, wall, reference, height, held, dt));
        held = height;
        lever.advance(dt);
        bump = std::max(bump, lever.true_height() - kFloor);
    }
    return bump;
}

double least_false_bump(const WallSettings& settings, const FingerSettings& finger, double speed, double before, double late) {
    LeverSettings lever = settings.lever;
    lever.delay = 0;
    constexpr double kStep = 1e-4;
    SimulatedLever rises(lever, finger, kFloor - hangs(settings));
    double half = settings.lever.delay;
    for (; rises.true_height() < (kFloor + kWallTop) / 2 && half < 1; half += kStep) {
        rises.push(lever.most_force);
        rises.advance(kStep);
    }
    const double begins = speed * half - late;                      // mm before the edge
    const double brakes = speed * speed / (2 * kBraking) + before;  // mm before the edge
    SimulatedLever mouse(lever, finger, kFloor - hangs(settings));
    double bump = 0;
    const double pushed = (begins - brakes) / speed;
    if (pushed <= 0) return 0;
    for (double time = 0; time < pushed + 0.1; time += kStep) {
        mouse.push(time < pushed ? lever.most_force : -lever.most_force);
        mouse.advance(kStep);
        bump = std::max(bump, mouse.true_height() - kFloor);
    }
    return bump;
}

}  // namespace tactics
