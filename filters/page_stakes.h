// SPDX-License-Identifier: Apache-2.0
// What drawing an arc is worth on a page, and what it costs.
#pragma once

#include <vector>

#include "filters/arc_worth.h"
#include "tactics/region_tree.h"

namespace tactics {

/// Of a step: drawing it gains its arc's worth less the price.
struct Stakes {
    std::vector<float> worth;  ///< of each arc: its chance and, on top, something for the chance that it is of the main thing
    double price = 0;
};

/// Of how good a page is expected to be, sure * P + (1 - sure) * (0.6 R + 0.4 M), the slope by the length of each arc, where the
/// parts that it leads to are about the best there are. P is the share of the page's line that people agree on, R the share that
/// is drawn of what they agree on, M that of the main thing's outline, which is taken for 0.7 diagonals of the picture longer
/// than it is expected to be. So a clear picture gets only what is clear, and one where little is clear the best of that. `sure`:
/// 0 to 1.
Stakes stakes_of(const RegionTree& tree, const ArcChances& chances, double sure);

}  // namespace tactics
