// SPDX-License-Identifier: Apache-2.0
// K-means on a histogram, solved exactly: the best of all divisions of levels into classes, not the best of a few trials.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "filters/histogram.h"

namespace tactics {

struct Classes {
    std::vector<std::size_t> first;  ///< index of the first level of each class that occurs, rising
    std::vector<double> centres;     ///< weighted mean of each class, rising
    double squares = 0;              ///< weighted sum of squared distances to the centres

    /// The class of a level by its index.
    std::size_t class_of(std::size_t level) const;
};

/// Cuts levels (strictly rising values; weights >= 0, finite) into at most `k` classes with the least sum of squares.
///
/// Levels of weight 0 do not count: fewer than k levels that occur give one class each, none at all gives no class. Of
/// equally good cuts the one with the lower borders is taken, from the highest border down. O(k n log n).
Classes kmeans_exact(std::span<const Level> levels, int k);

}  // namespace tactics
