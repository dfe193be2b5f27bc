// SPDX-License-Identifier: Apache-2.0
// A scene with the duration of its answers.
#pragma once

#include <chrono>

#include "tactics/haptics/loop/loop.h"
#include "tactics/haptics/scenes/scene.h"

namespace tactics {

/// Behaves like `scene`, which must outlive it. The times include reading the clock, some hundredths of a microsecond.
class TimedScene final : public Scene {
public:
    explicit TimedScene(Scene& scene) : scene_(scene) {}
    Felt feel(const Touch& touch, double dt) noexcept override {
        using Steady = std::chrono::steady_clock;
        const Steady::time_point begin = Steady::now();
        const Felt felt = scene_.feel(touch, dt);
        times_.add(std::chrono::duration<double>(Steady::now() - begin).count());
        return felt;
    }
    void begin_again() noexcept override { scene_.begin_again(); }
    const Lateness& times() const noexcept { return times_; }

private:
    Scene& scene_;
    Lateness times_;
};

}  // namespace tactics
