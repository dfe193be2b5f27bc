// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/deadband.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tactics/point3.h"

namespace tactics {

namespace {

constexpr std::int64_t kSlopeParts = 256;
// Ours: of lines through so many last ticks, told half a threshold off at most, the fewest are needed on reliefs and plots that
// simulated hands feel (4 to 32 ticks, and from nothing to the whole threshold, were tried).
constexpr std::size_t kFitted = 16;
constexpr double kMostAside = 0.5;

Point3 real(const Steps3& steps) {
    return {static_cast<double>(steps.x), static_cast<double>(steps.y), static_cast<double>(steps.z)};
}

Steps3 nearest(const Point3& point) { return {std::llround(point.x), std::llround(point.y), std::llround(point.z)}; }

double work_of(const Steps3& guess, const Steps3& force, const Steps3& from, const Steps3& to) {
    return dot(real(guess) - real(force), real(to) - real(from));
}

// The line through the last ticks before and at `tick`, by least squares.
struct Line {
    Point3 end, slope;  // at the tick; a tick
};

Line line_to(std::span<const Steps3> forces, std::size_t tick) {
    const std::size_t count = std::min(tick + 1, kFitted);
    const double last = static_cast<double>(count) - 1, middle = last / 2;
    Point3 mean, tilt;
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Point3 force = real(forces[tick + 1 - count + i]);
        const double from_middle = static_cast<double>(i) - middle;
        mean = mean + 1.0 / static_cast<double>(count) * force;
        tilt = tilt + from_middle * force;
        squares += from_middle * from_middle;
    }
    const Point3 slope = squares > 0 ? 1 / squares * tilt : Point3{};
    return {mean + middle * slope, slope};
}

// What is best told of a force that may be missed by `threshold`.
ForceTold told_of(std::span<const Steps3> forces, std::size_t tick, double threshold, ForceGuess guess) {
    const Steps3& force = forces[tick];
    if (guess == ForceGuess::hold || force == Steps3{}) return {force, {}};
    const Line line = line_to(forces, tick);
    ForceTold told{nearest(real(force) + within(line.end - real(force), kMostAside * threshold)),
                   nearest(static_cast<double>(kSlopeParts) * line.slope)};
    if (length_of(real(told.force) - real(force)) > threshold) told.force = force;
    return told;
}

}  // namespace

Steps3 GuessedForce::now() const noexcept {
    const auto moved = [this](std::int64_t force, std::int64_t slope) { return force + slope * since_ / kSlopeParts; };
    return {moved(told_.force.x, told_.slope.x), moved(told_.force.y, told_.slope.y), moved(told_.force.z, told_.slope.z)};
}

std::vector<ToldAt> forces_told(std::span<const Steps3> forces, std::span<const Steps3> places, const Deadband& deadband,
                                double& added) {
    std::vector<ToldAt> all;
    GuessedForce guessed;
    for (std::size_t tick = 0; tick < forces.size(); ++tick, guessed.tick()) {
        const Steps3& force = forces[tick];
        const Steps3 &from = places[tick], &to = places[std::min(tick + 1, places.size() - 1)];
        const double threshold = std::max(deadband.share * length_of(real(force)), deadband.floor);
        const auto too_much = [&](const Steps3& guess) {
            return guess != force && std::max(added, 0.0) + work_of(guess, force, from, to) > deadband.allowance;
        };
        if (tick == 0 || length_of(real(guessed.now()) - real(force)) > threshold || too_much(guessed.now())) {
            ForceTold told = told_of(forces, tick, threshold, deadband.guess);
            if (too_much(told.force)) told.force = force;
            guessed.tell(told);
            all.push_back({tick, told});
        }
        added = std::max(added, 0.0) + work_of(guessed.now(), force, from, to);
    }
    return all;
}

}  // namespace tactics
