// SPDX-License-Identifier: Apache-2.0
// Things moved off each other, so that what is folded out of them has room. Which is left of which, and above, stays.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/solid/panel.h"

namespace tactics {

/// The displacement of each part that puts things `times` as far from their common middle, in the plane of the view. Things that
/// touch or overlap in that plane stay together. Empty: all do.
std::vector<Point3> spread_by(const std::vector<ModelPart>& parts, const std::vector<std::uint32_t>& thing, const ViewPlane& view,
                              double times);

}  // namespace tactics
