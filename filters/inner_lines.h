// What is inside a thing and too small to be one: eyes, a mouth, a stripe.
#pragma once

#include <vector>

#include "filters/outline_choice.h"
#include "tactics/region_tree.h"

namespace tactics {

/// The lines along arcs of at least that strength (0 to 255) within parts that are enclosed: the picture's frame bounds little of
/// them. What the picture does not enclose is ground, or a body below a head.
std::vector<RegionLine> inner_lines_of(const RegionTree& tree, const Parts& parts, float least);

}  // namespace tactics
