// SPDX-License-Identifier: Apache-2.0
// A grid as a chain: each value guessed from those before it in its row, whatever is above. Recordings are chains, and so is all
// that is written row by row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "tactics/information/adaptive_code.h"
#include "tactics/information/counted_rows.h"

namespace tactics {

/// Whole numbers from 0 to levels - 1, at most 255, read row by row, so that nobody needs a copy of all.
struct ChainCells {
    std::size_t rows = 0, columns = 0, levels = 0;
    std::function<void(std::uint8_t* to, std::size_t row)> load;  ///< rows come in order
    /// Whether the values of this row are counted; if not, they are only known to the row below.
    std::function<bool(std::size_t row)> counts;
};

/// What was counted of a chain in which each value is guessed from so many before it.
struct ChainCounts {
    std::size_t order = 1;
    bool restarts = true;                            ///< each row begins anew; else it goes on from the end of the one before
    std::vector<std::uint32_t> main;                 ///< by the values before it, the nearest counting least, then by the value
    std::vector<std::vector<std::uint32_t>> begins;  ///< the same of values that have fewer before them: none, one ...
};

/// The shortest code of a chain, of all orders that take no more than `most` counters, with and without beginning anew.
struct ChainCode {
    Code code;
    ChainCounts counts;
    std::vector<Code> tried;  ///< all of them
};
ChainCode shortest_chain(const ChainCells& cells, std::size_t most);

/// Tells of each cell of these rows that counts, row by row: log2 of one by its share behind those before it.
void tell_costs(const ChainCells& cells, const ChainCounts& counts, std::span<const RowRange> parts, const TakeCosts& take);

}  // namespace tactics
