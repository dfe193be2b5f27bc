// SPDX-License-Identifier: Apache-2.0
// The ground and the stroke over it by which surfaces are timed: a terrain of 160 x 120 mm, 100 mm/s at 1 kHz, from 3 mm above to
// 3 mm below it.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "tactics/haptics/scenes/relief_surface.h"
#include "tactics/point3.h"
#include "tests/haptics/reliefs.h"

namespace tactics {

inline constexpr double kStrokeWidth = 160, kStrokeHeight = 120;  // mm
inline constexpr double kStrokeStep = 0.1;                        // mm

inline HeightMap stroke_ground(double pitch) {
    return map_of(static_cast<int>(kStrokeWidth / pitch), static_cast<int>(kStrokeHeight / pitch), pitch, terrain);
}
inline double pitch_of(double triangles) { return std::sqrt(2 * kStrokeWidth * kStrokeHeight / triangles); }

/// Straight from place to place.
inline std::vector<Point3> stroke(const ReliefSurface& felt, int ticks) {
    RandomNumbers random(3);
    std::vector<Point3> way;
    Point at{kStrokeWidth / 2, kStrokeHeight / 2}, goal = at;
    for (int i = 0; i < ticks; ++i) {
        if (distance(at, goal) < 2 * kStrokeStep) goal = {kStrokeWidth * random.uniform(), kStrokeHeight * random.uniform()};
        const double part = std::min(kStrokeStep / std::max(distance(at, goal), kStrokeStep), 1.0);
        at = {at.x + (goal.x - at.x) * part, at.y + (goal.y - at.y) * part};
        way.push_back({at.x, at.y, felt.height(at) + 3 * std::sin(0.003 * i)});
    }
    return way;
}

struct Nanoseconds {
    double p50, p999;
};

/// One update at a time, less what reading the clock takes.
template <typename Update>
Nanoseconds percentiles(const std::vector<Point3>& way, Update update) {
    const auto measure = [&](auto what) {
        std::vector<double> took;
        took.reserve(way.size());
        for (const Point3& finger : way) {
            const auto begin = std::chrono::steady_clock::now();
            what(finger);
            took.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count());
        }
        std::sort(took.begin(), took.end());
        return Nanoseconds{took[took.size() / 2], took[took.size() / 1000 * 999]};
    };
    const double clock = measure([](const Point3&) {}).p50;
    const Nanoseconds all = measure(update);
    return {all.p50 - clock, all.p999 - clock};
}

}  // namespace tactics
