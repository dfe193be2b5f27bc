// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/relief_space_scene.h"

namespace tactics {

Felt ReliefSpaceScene::feel(const Touch& touch, double) noexcept {
    Felt felt;
    if (!is_finite(touch.finger)) return felt;
    const Point3 outside = proxy_.follow(touch.finger);
    felt.force = pull(law_, outside, touch);
    felt.surface = surface_.height({touch.finger.x, touch.finger.y});
    felt.reference = outside.z;
    return felt;
}

}  // namespace tactics
