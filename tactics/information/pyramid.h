// SPDX-License-Identifier: Apache-2.0
// A scene with less and less detail: what a device filter leaves of it (section 4 of the paper), and the levels of detail between
// which one is chosen.
#pragma once

#include <deque>
#include <map>
#include <utility>
#include <vector>

#include "tactics/information/grid.h"

namespace tactics {

/// What becomes of the cells that are put into one.
enum class Pooling {
    mean,     ///< heights: a place is as high as it is on average
    highest,  ///< lines: a dot is raised where one goes through
};

/// So many cells along the longer side, with the mean of those that are put into one: `longest` is at most the grid's own.
LevelGrid resampled(const LevelGrid& grid, int longest, Pooling pooling);

/// The other way, each cell over as many as it was made of.
LevelGrid enlarged(const LevelGrid& grid, int columns, int rows);

/// Along the longer side the sizes that a scene is tried in: sixteen to a doubling, from 1 on, and its own.
std::vector<int> sizes_to_try(int longest);
/// The numbers of levels that it is tried in, from 2 on: all to 8, four to a doubling, and its own.
std::vector<int> levels_to_try(int levels);

/// The grid in all the sizes and levels that are asked for, each made and measured once.
class Pyramid {
public:
    Pyramid(LevelGrid grid, Pooling pooling);

    const LevelGrid& whole() const { return halves_.front(); }
    Pooling pooling() const { return pooling_; }
    /// With so many cells along the longer side, at most as many as there are.
    const LevelGrid& at(int longest);
    /// Bits of its shortest code there, in so many levels.
    double bits(int longest, int levels);
    /// The most bits of all sizes and levels to try that are no finer than these: who can show more can show less, so a finer
    /// medium never counts as a poorer one. At most the bits of the whole.
    double most_bits(int longest, int levels);
    /// What is wrong with the scene there, root mean square, in levels of the whole: each cell stands for the middle of its
    /// level.
    double error(int longest, int levels);

private:
    Pooling pooling_;
    std::deque<LevelGrid> halves_;  // each half as large as the one before
    std::map<int, LevelGrid> sizes_;
    std::map<std::pair<int, int>, double> bits_;
};

}  // namespace tactics
