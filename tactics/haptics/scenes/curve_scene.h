// SPDX-License-Identifier: Apache-2.0
// The curves of a plot as virtual fixtures: they attract a near finger, but only perpendicularly to the line, so that it can
// slide along.
#pragma once

#include "tactics/haptics/scenes/fixture.h"
#include "tactics/haptics/scenes/line_field.h"
#include "tactics/haptics/scenes/scene.h"

namespace tactics {

/// The pull is also damped perpendicularly to the line, fully from half of its strength on. Along the line there is no force.
class CurveScene final : public Scene {
public:
    CurveScene(const std::vector<std::vector<Point>>& lines, const FixtureSettings& fixture, double damping_ns_per_m = 0);
    Felt feel(const Touch& touch, double dt) noexcept override;
    void begin_again() noexcept override {}

private:
    LineField lines_;
    FixtureSettings fixture_;
    double damping_;  // N s/mm
};

}  // namespace tactics
