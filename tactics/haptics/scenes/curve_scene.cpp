// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/curve_scene.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "tactics/haptics/scenes/plot_part.h"

namespace tactics {

namespace {

// A rod is solid: where two meet a finger feels each, and nothing is rounded that could be felt beyond a rod's width.
LineField::Reach reach_of_curve_scene(const FixtureSettings& fixture) {
    LineField::Reach reach;
    reach.far = fixture.radius;
    reach.blend = std::min(reach.blend, fixture.radius / 2);
    return reach;
}

// No part of it is steeper than what the device bears.
FixtureSettings borne(FixtureSettings fixture, const ForceLaw& law) {
    const FixtureSlopes slopes = slopes_of(fixture);
    const double steepest = fixture.form == FixtureForm::rod ? slopes.fall : slopes.rise;
    if (steepest > law.stiffness) fixture.strength *= law.stiffness / steepest;
    return fixture;
}

std::unique_ptr<Scene> make_curve_scene(const PlotFeel& feel, std::vector<Phrase>& told) {
    const FeltLines felt = felt_lines(feel.plot, feel.frame, feel.resolution);
    if (felt.lines.empty()) return nullptr;
    if (felt.kept < felt.points)
        told.push_back(
            phrase("{0} points of the curves are felt as {1}: the others lie no further off than the device tells apart",
                   std::to_string(felt.points), std::to_string(felt.kept)));
    return std::make_unique<CurveScene>(felt.lines, borne(feel.fixture, feel.law), feel.law.damping_ns_per_m);
}

}  // namespace

extern const PlotPart curves_part;
const PlotPart curves_part{"curves", "lines that attract a finger", make_curve_scene};

CurveScene::CurveScene(const std::vector<std::vector<Point>>& lines, const FixtureSettings& fixture, double damping_ns_per_m)
    : lines_(lines, reach_of_curve_scene(fixture)), fixture_(fixture), damping_(damping_ns_per_m / 1000) {}

Felt CurveScene::feel(const Touch& touch, double) noexcept {
    Felt felt;
    const LineField::Felt near = lines_.at(touch.finger);
    if (!near.within) return felt;
    const double pulled = pull(fixture_, near.distance), share = std::min(1.0, 2 * std::abs(pulled) / fixture_.strength);
    felt.force = -(pulled + damping_ * share * dot(touch.velocity, near.slope)) * near.slope;
    return felt;
}

}  // namespace tactics
