// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/relief_scene.h"

namespace tactics {

namespace {

double height_of(const void* surface, Point at) noexcept { return static_cast<const ReliefSurface*>(surface)->height(at); }

}  // namespace

ReliefScene::ReliefScene(const ReliefSurface& surface, const ReliefFeel& feel)
    : surface_(surface), settings_(feel.wall), wall_(feel.wall), edges_(feel.edges, feel.wall.lever.rate_hz) {}

Felt ReliefScene::feel(const Touch& touch, double dt) noexcept {
    const Point at{touch.finger.x, touch.finger.y};
    if (!touched_) finger_before_ = touch.finger.z;
    touched_ = true;
    Felt felt;
    felt.reference = wall_.reference({&surface_, height_of}, at, {touch.velocity.x, touch.velocity.y}, dt, touch.doubt);
    felt.surface = surface_.height(at);
    const double held = wall_force(settings_, wall_, felt.reference, touch.finger.z, finger_before_, dt);
    const double swing = edges_.force(felt.surface, at, dt);
    // A finger in the air feels no edge.
    felt.force.z = held != 0 ? held + swing : 0;
    finger_before_ = touch.finger.z;
    return felt;
}

}  // namespace tactics
