// SPDX-License-Identifier: Apache-2.0
// How much one value of a grid tells, and two of them together: equations 1 and 6 to 8 of K. Moustakas, "Handling haptics as a
// stand-alone medium" (WSCG 2013). These count values and not where they are; code_length.h does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tactics/information/grid.h"

namespace tactics {

/// Of what was counted, bits a value.
struct Entropy {
    double plug_in = 0;  ///< of the shares that were seen, which is too little by about (distinct - 1) / (2 n ln 2)
    /// With that put right (G. A. Miller 1955; W. G. Madow), and no more than log2 of the distinct values, which it nears from
    /// below.
    double corrected = 0;
    std::size_t distinct = 0;  ///< values that were seen
};
Entropy entropy_of(std::span<const std::uint64_t> counts);

/// How often each level is in it, or in these of its rows.
std::vector<std::uint64_t> counts_of(const LevelGrid& grid);
std::vector<std::uint64_t> counts_of(const LevelGrid& grid, std::span<const RowRange> rows);
Entropy entropy_of(const LevelGrid& grid);

/// Of two grids of one shape, cell by cell; bits a cell.
struct JointEntropy {
    Entropy first, second, joint;

    double conditional() const;  ///< H(first | second) = H(first, second) - H(second), corrected, at least 0
    double mutual() const;       ///< I(first; second) = H(first) + H(second) - H(first, second), corrected, at least 0
};
/// Throws std::logic_error: other shapes. Takes 4 bytes a cell, or 8 MB.
JointEntropy joint_entropy(const LevelGrid& first, const LevelGrid& second);

}  // namespace tactics
