// SPDX-License-Identifier: Apache-2.0
// Things that stand close together on one thing, as on a table: moved off each other, so that a finger finds each of them whole.
// M. Kurze, CHI 1997, step 6: "moving the objects (in 2D) away from each other".
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/solid/panel.h"

namespace tactics {

/// The displacement of each part, in the plane of the view, that leaves `gap` mm of the model free between things that stand
/// beside each other, and between them and the border of what they stand on. A place is information: in all, nothing moves by
/// more than `gap`, nor by more than half of its width on what it stands on; things that are near each other keep their order to
/// the right and downwards. What stands on something or is under it goes with it, and stays on it. On the ground, things that
/// touch in space stay together. Where there is less room than the gap, gaps are smaller; what cannot be parted so far stays
/// where it is. Seen from the front, things move to the sides only, as they stand on something there. Empty: nothing moves.
std::vector<Point3> moved_off(const std::vector<ModelPart>& parts, const std::vector<std::uint32_t>& thing, const ViewPlane& view,
                              double gap);

}  // namespace tactics
