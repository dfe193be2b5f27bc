// SPDX-License-Identifier: Apache-2.0
// What a finger gains that is led round and back to where it was.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "tactics/haptics/scenes/scene.h"

namespace tactics {

// N mm on the way round; a force that has a potential gains nothing.
inline double work_round(Scene& scene, const std::function<Point3(double)>& place) {
    constexpr int kSteps = 200'000;
    double work = 0;
    Point3 from = place(0);
    for (int i = 1; i <= kSteps; ++i) {
        const Point3 to = place(static_cast<double>(i % kSteps) / kSteps), way = to - from;
        Touch touch;
        touch.finger = 0.5 * (from + to);
        work += dot(scene.feel(touch, 0.001).force, way);
        from = to;
    }
    return work;
}

inline std::function<Point3(double)> loop_round(const Point3& middle, double radius) {
    return [=](double share) {
        const double angle = 2 * std::numbers::pi * share;
        return middle + Point3{radius * std::cos(angle), radius * std::sin(angle), 0.3 * radius * std::sin(2 * angle)};
    };
}

inline constexpr double kNanojoule = 1e-6;  // N mm

}  // namespace tactics
