// SPDX-License-Identifier: Apache-2.0
// What is told of the information in a grid: never one bare number, for the entropy of levels knows nothing of where they are,
// and nobody knows the entropy of a picture.
#pragma once

#include <optional>

#include "tactics/information/entropy.h"
#include "tactics/information/grid.h"

namespace tactics {

struct Measures {
    double raw = 0;  ///< bits of the whole, as its values are written one by one
    Entropy alone;   ///< bits a cell, of the levels wherever they are
    /// Bits of the whole by the shortest code (code_length.h), without and with the cost of learning it. What a source of known
    /// entropy gives lies between; a grid of nobody's making may hold less than `low`, if somebody finds how it was made.
    double low = 0, high = 0;
    double spatial = 0;          ///< bits of the whole by a code that looks at neighbours, whether or not it is the shortest
    std::optional<double> felt;  ///< bits of the whole that are enough for a finger (felt_rate.h), at most `high`

    /// 1 - (bits of the spatial code) / (bits of the levels alone): 1 where neighbours tell everything, 0 or a little less where
    /// they tell nothing, as in noise or when its cells are shuffled. 0 for a grid of one level.
    double topology = 0;
};

/// `felt_error`: in levels, what nobody feels (felt_rate.h); nothing: it is not known.
Measures measure(const LevelGrid& grid, std::optional<double> felt_error);

}  // namespace tactics
