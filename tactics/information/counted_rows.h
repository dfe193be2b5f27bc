// SPDX-License-Identifier: Apache-2.0
// Which rows of a grid are counted: all, or of a large one bands that stand for the rest.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "tactics/information/grid.h"

namespace tactics {

using RowRange = std::pair<std::size_t, std::size_t>;  ///< from the first up to, not with, the second

/// Of one slice of 3.75 million cells or more, one and a half million are counted, in bands of eight rows, one at a random
/// place in each of as many even parts of the height, the same in each run. Every cell is looked at, however: how much it differs
/// from the one beside it says whether the bands stand for the rest. Where they do not to a twentieth, all rows are counted.
class CountedRows {
public:
    /// `whole` must outlive it.
    explicit CountedRows(const LevelGrid& whole);

    /// The bands one under the other, or the grid as it is.
    const LevelGrid& grid() const { return bands_.count() > 0 ? bands_ : whole_; }
    /// A row of it that is not is there for those below it.
    bool counts(std::size_t row) const { return bands_.count() == 0 || row % kBand >= kBefore; }
    double cells() const;                      ///< that are counted
    double share() const;                      ///< of those of the whole grid
    double unlike() const { return unlike_; }  ///< what the bands have more or less of differences than the rest, as a share
    /// Parts of it that show how it varies: all of it if that is not much.
    std::vector<RowRange> parts() const;

    static constexpr std::size_t kBefore = 2, kBand = kBefore + 8;

private:
    const LevelGrid& whole_;
    LevelGrid bands_;
    double unlike_ = 0;
};

}  // namespace tactics
