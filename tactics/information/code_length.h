// SPDX-License-Identifier: Apache-2.0
// How short a grid can be written by who looks at where values are: codes that guess each value from its neighbours, with
// what they cost to learn. Nothing is written, only counted.
//
// Six kinds are tried and the shortest counts:
//   levels alone        each value by itself;
//   neighbours          the exact values of 1 to 10 cells that come before it, as many as four counters a cell hold, and no more
//                       than 2^18 (as JBIG does);
//   chain               the exact values of 1 to 10 cells before it in the row, of up to 64 levels (chain_code.h), or above
//                       it in the column where all rows are counted;
//   prediction          the error of the median edge detector of JPEG-LS (ITU-T T.87, A.4.1; on voxels the median of the three
//                       cells before it), by how rough it is around. Of over 256 levels large errors are counted in classes of
//                       an eighth of a power of two, whose rest is written as it is;
//   repetition          of a grid in which each cell equals the one up to 128 rows and columns before it, only those without
//                       such a cell are written;
//   enlargement         rows and columns that equal the one before are left out, if two thirds of the cells or fewer remain.
// Each is an adaptive code by R. E. Krichevsky and V. K. Trofimov (1981), whose length depends only on what was counted, so one
// pass is enough, and which needs no table: what it costs to learn is in it.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/information/adaptive_code.h"
#include "tactics/information/counted_rows.h"

namespace tactics {

/// Of the whole grid.
struct CodeLength {
    Code best;     ///< of all codes, and of writing the values as they are
    Code alone;    ///< of the levels alone
    Code spatial;  ///< the best of those that look at neighbours
    /// The least that a code says is in it (Code::corrected), of those that have four cells or more for each share that they
    /// learn: where cells are few, the shortest code leaves out what there is.
    double least = 0;
    /// Bits by which a grid of the same source may have more or less, and by which rows that were not counted may: three standard
    /// deviations, from how the bits of cells and of parts of the grid differ and from one cell that nobody could foresee.
    double doubt = 0;
};

/// Two threads from a million cells on, with the same result. Without the doubt; what is written is the same with it. Besides
/// the grid it needs counters of up to some 20 MB and 64 columns, of one that is enlarged the smaller one, and of a large one
/// the rows that are counted.
CodeLength code_length(const LevelGrid& grid);
/// With it. `seen`: how often each level is in the rows that are counted (counts_of).
CodeLength code_length(const CountedRows& rows, const std::vector<std::uint64_t>& seen);

/// By levels alone, neighbours and prediction only, or as the values are written: faster, and enough for a part of a picture.
double neighbour_bits(const LevelGrid& grid);

}  // namespace tactics
