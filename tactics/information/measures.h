// SPDX-License-Identifier: Apache-2.0
// What is told of the information in a grid: never one bare number, for the entropy of levels knows nothing of where they are,
// and nobody knows the entropy of a picture.
#pragma once

#include <optional>

#include "tactics/information/entropy.h"
#include "tactics/information/grid.h"

namespace tactics {

struct Measures {
    double raw = 0;   ///< bits of the whole, as its values are written one by one
    Entropy alone;    ///< bits a cell, of the levels wherever they are
    double bits = 0;  ///< of the whole by the shortest code (code_length.h): in so many it can be written
    /// The least that a code finds and what the shortest one needs, each with what other grids of the same source may have less
    /// or more (CodeLength::least, doubt). The entropy lies between if each cell is drawn by chance and by a few cells next to
    /// it, in the same way all over, or if such a grid was enlarged, by 1.5 % of each side or more, or repeats from edge to edge
    /// every 128 cells or fewer (repeats.h). A grid that was made by another rule may hold less than `low`: a pattern with a
    /// margin, one that repeats after more cells, a mirrored one; and, by a few hundredths, one that has two sources side by
    /// side. `high` is at most `raw`.
    double low = 0, high = 0;
    double counted = 1;          ///< share of the rows that were counted and stand for the rest
    double spatial = 0;          ///< bits of the whole by a code that looks at neighbours, whether or not it is the shortest
    std::optional<double> felt;  ///< bits of the whole that are enough for a finger (felt_rate.h), at most `bits`

    /// 1 - (bits of the spatial code) / (bits of the levels alone): 1 where neighbours tell everything, 0 or a little less where
    /// they tell nothing, as in noise or when its cells are shuffled. 0 for a grid of one level.
    double topology = 0;
};

/// `felt_error`: in levels, what nobody feels (felt_rate.h); nothing: it is not known.
Measures measure(const LevelGrid& grid, std::optional<double> felt_error);

}  // namespace tactics
