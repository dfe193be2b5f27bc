// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/curve_scene.h"

#include <algorithm>

namespace tactics {

namespace {

// A rod is solid: where two meet a finger feels each, and nothing is blended that could be felt beyond a rod's width.
NearLines::Reach reach_of(const FixtureSettings& fixture) {
    NearLines::Reach reach;
    reach.far = fixture.radius;
    reach.blend = std::min(reach.blend, fixture.radius / 2);
    return reach;
}

}  // namespace

CurveScene::CurveScene(const std::vector<std::vector<Point>>& lines, const FixtureSettings& fixture)
    : lines_(lines, reach_of(fixture)), fixture_(fixture) {}

Felt CurveScene::feel(const Touch& touch, double) noexcept {
    Felt felt;
    const Nearness near = lines_.at(touch.finger);
    if (near.within) felt.force = -pull(fixture_, near.distance) * near.slope;
    return felt;
}

}  // namespace tactics
