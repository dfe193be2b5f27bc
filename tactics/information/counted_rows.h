// SPDX-License-Identifier: Apache-2.0
// Which rows of a grid are counted: all, or of a large one bands that stand for the rest.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "tactics/information/grid.h"
#include "tactics/information/repeats.h"

namespace tactics {

using RowRange = std::pair<std::size_t, std::size_t>;  ///< from the first up to, not with, the second

/// Of one slice of 2.5 million cells and 640 rows or more, a million cells are counted, or 256 rows if that is more, in bands of
/// eight rows. The height is divided evenly into as many parts as there are bands, and each part has a band at a random place,
/// the same in each run. Of all rows, however, three things are looked at: the differences of cells from those to the left, from
/// those above, and what comes as a surprise behind the same neighbours, however small. Of eight draws that one is taken whose
/// rows are most like the whole in these. Where one is not as large to a twentieth, twice as many rows are counted, and so on,
/// and in the end all. All are counted, too, where a pattern repeats (shift_of).
class CountedRows {
public:
    /// `whole` must outlive it.
    explicit CountedRows(const LevelGrid& whole);

    /// The bands one under the other, or the grid as it is.
    const LevelGrid& grid() const { return bands_.count() > 0 ? bands_ : whole_; }
    /// Whether this row of `grid` is counted. The first two rows of a band are not: they are only the neighbours of those below.
    bool counts(std::size_t row) const { return bands_.count() == 0 || row % kBand >= kBefore; }
    double cells() const;  ///< that are counted
    double share() const;  ///< of those of the whole grid
    const LevelGrid& whole() const { return whole_; }
    const std::optional<Shift>& shift() const { return shift_; }  ///< shift_of the whole
    /// How far those three in the bands are from those of the whole grid, as a share of these.
    double unlike() const { return unlike_; }
    /// Parts of it that show how it varies: each band, or all of it if that is not much.
    std::vector<RowRange> parts() const;

    static constexpr std::size_t kBefore = 2, kBand = kBefore + 8;

private:
    void take(const std::vector<std::size_t>& firsts);

    const LevelGrid& whole_;
    std::optional<Shift> shift_;
    LevelGrid bands_;
    double unlike_ = 0;
};

/// Parts of a grid of so many rows, all of which count, that show how it varies.
std::vector<RowRange> parts_of(std::size_t rows, std::size_t columns);

}  // namespace tactics
