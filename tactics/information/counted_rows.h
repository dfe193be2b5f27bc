// SPDX-License-Identifier: Apache-2.0
// Which rows of a grid are counted: all, or of a large one bands that stand for the rest.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tactics/information/grid.h"
#include "tactics/information/repeats.h"

namespace tactics {

/// Of one slice of 2.5 million cells and 640 rows or more, a million cells are counted, or 256 rows if that is more, in bands of
/// eight rows. The height is divided evenly into as many parts as there are bands, and each part has a band at a random place,
/// the same in each run. Of all rows, however, three things are looked at: the differences of cells from those to the left, from
/// those above, and what comes as a surprise behind the same neighbours, however small. Of eight draws that one is taken whose
/// rows are most like the whole in these. Where one is not as large to a twentieth, twice as many rows are counted, and so on,
/// and in the end all.
class CountedRows {
public:
    /// `whole` must outlive it.
    explicit CountedRows(const LevelGrid& whole);

    /// Rows that are looked at: the bands one under the other, or all.
    const std::vector<RowRange>& looked_at() const { return looked_at_; }
    std::size_t rows() const;         ///< that are looked at
    std::size_t cells_there() const;  ///< that are in them
    /// Which row of the whole one of them is.
    std::size_t at(std::size_t row) const { return is_part() ? looked_at_[row / kBand].first + row % kBand : row; }
    /// Whether it is counted. The first two rows of a band are not: they are only the neighbours of those below.
    bool counts(std::size_t row) const { return !is_part() || row % kBand >= kBefore; }
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
    bool is_part() const { return looked_at_.size() > 1; }

    const LevelGrid& whole_;
    std::optional<Shift> shift_;
    std::vector<RowRange> looked_at_;
    double unlike_ = 0;
};

/// Parts of a grid of so many rows, all of which count, that show how it varies.
std::vector<RowRange> parts_of(std::size_t rows, std::size_t columns);

}  // namespace tactics
