// SPDX-License-Identifier: Apache-2.0
// How short a grid can be written by who looks at where values are: codes that guess each value from its neighbours, with
// what they cost to learn. Nothing is written, only counted.
//
// Three kinds are tried and the shortest counts:
//   levels alone        each value by itself;
//   neighbours          the exact values of 1 to 10 cells that come before it, as many as four counters a cell hold, and no more
//                       than 2^18 (as JBIG does);
//   prediction          the error of the median edge detector of JPEG-LS (ITU-T T.87, A.4.1; on voxels the median of the three
//                       cells before it), by how rough it is around. Of over 256 levels large errors are counted in classes of
//                       an eighth of a power of two, whose rest is written as it is.
// Each is an adaptive code by R. E. Krichevsky and V. K. Trofimov (1981), whose length depends only on what was counted, so one
// pass is enough, and which needs no table: what it costs to learn is in it.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/information/adaptive_code.h"
#include "tactics/information/grid.h"

namespace tactics {

/// Of the whole grid.
struct CodeLength {
    Code best;     ///< of all codes, and of writing the values as they are
    Code alone;    ///< of the levels alone
    Code spatial;  ///< the best of those that look at neighbours
};

/// Two threads from a million cells on, with the same result. Needs some 10 MB besides the grid.
CodeLength code_length(const LevelGrid& grid);
/// The same where it is known how often each level is in it (counts_of).
CodeLength code_length(const LevelGrid& grid, const std::vector<std::uint64_t>& seen);

}  // namespace tactics
