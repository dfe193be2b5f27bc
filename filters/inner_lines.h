// SPDX-License-Identifier: Apache-2.0
// Details inside a thing that are too small to be things: eyes, a mouth, a stripe.
#pragma once

#include <vector>

#include "filters/outline_choice.h"
#include "tactics/region_tree.h"

namespace tactics {

/// For each face, whether it belongs to an enclosed part, of which the picture's frame bounds little. Other parts are background,
/// or a body below a head.
std::vector<bool> enclosed_faces(const RegionTree& tree, const Parts& parts);

/// The lines along arcs of at least that strength (0 to 255) that `parts` do not divide and that have a face of `within` on both
/// sides.
std::vector<RegionLine> inner_lines_of(const RegionTree& tree, const Parts& parts, const std::vector<bool>& within, float least);

}  // namespace tactics
