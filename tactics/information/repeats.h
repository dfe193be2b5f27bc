// SPDX-License-Identifier: Apache-2.0
// What of a grid is there more than once, exactly: whole rows and columns like the one before, and a pattern that comes again
// and again.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tactics/information/grid.h"

namespace tactics {

/// A grid without the rows and the columns that equal the one before, each as a whole: of one that was enlarged by whatever
/// factors, the one that it was made of.
struct Reduced {
    LevelGrid grid;
    double said = 0;  ///< bits: which rows and columns are left out
};
/// Nothing if more than 97 % of the cells remain, if only rows of one value would be left out, and of voxels.
std::optional<Reduced> reduced(const LevelGrid& grid);

/// Each cell equals that so many rows above it and so many columns to its left (or, under 0, to its right), if there is one.
struct Shift {
    int aside = 0, down = 0;
};
/// The one that leaves the fewest cells without such a cell, neither over kMostShift nor over half of the grid. Nothing if there
/// is none, of one level, and of voxels. Of many that hold in most rows but not in all, the first few are tried. It must hold in
/// the whole grid: a pattern with a margin has none, nor has one that is mirrored.
std::optional<Shift> shift_of(const LevelGrid& grid);
inline constexpr int kMostShift = 128;

/// The cells from which a grid with such a shift follows: whole rows at the top, then columns at a side, each if there are any.
std::vector<LevelGrid> borders_of(const LevelGrid& grid, const Shift& shift);

}  // namespace tactics
