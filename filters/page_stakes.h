// SPDX-License-Identifier: Apache-2.0
// The value and the price of drawing an arc on a page.
#pragma once

#include <vector>

#include "filters/arc_worth.h"
#include "tactics/region_tree.h"

namespace tactics {

/// Price of a step: drawing it gains the worth of its arc minus the price.
struct Stakes {
    std::vector<float> worth;  ///< for each arc: its probability, plus a bonus for the probability that it belongs to the main
                               ///< thing
    double price = 0;
};

/// The slope of the expected quality of a page, sure * P + (1 - sure) * (0.6 R + 0.4 M), with respect to the length of each arc,
/// near the best choice of parts. P is the share of the page's line that people agree on, R the share of their agreed lines that
/// is drawn, M that of the main thing's outline, whose length is assumed to be 0.7 picture diagonals more than expected. So a
/// clear picture gets only its clear lines, and an unclear one the best of its lines. `sure`: 0 to 1.
Stakes stakes_of(const RegionTree& tree, const ArcChances& chances, double sure);

}  // namespace tactics
