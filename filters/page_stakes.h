// What drawing an arc is worth on a page, and what it costs.
#pragma once

#include <vector>

#include "filters/arc_worth.h"
#include "filters/outline_choice.h"
#include "tactics/region_tree.h"

namespace tactics {

/// Of a step: drawing it gains its arc's worth less the price.
struct Stakes {
    std::vector<float> worth;  ///< of each arc: its chance and, on top, something for the chance that it is of the main thing
    double price = 0;
};

/// How good a page is expected to be, 0 to 1: sure * P + (1 - sure) * C. P is the share of its line that people agree on, C the share
/// that is drawn of what they agree on, for two fifths of the main thing's outline. 0 if nothing is drawn. `sure`: 0 to 1.
double expected_good(const RegionTree& tree, const Parts& parts, const ArcChances& chances, double sure);

/// The slope of expected_good by the length of each arc, where the parts that it leads to are about the best there are. So a clear
/// picture gets only what is clear, and one where little is clear the best of that.
Stakes stakes_of(const RegionTree& tree, const ArcChances& chances, double sure);

}  // namespace tactics
