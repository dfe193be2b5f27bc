// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/measures.h"

#include <algorithm>

#include "tactics/information/code_length.h"
#include "tactics/information/felt_rate.h"

namespace tactics {

Measures measure(const LevelGrid& grid, std::optional<double> felt_error) {
    check_grid(grid);
    const CountedRows rows(grid);
    const std::vector<std::uint64_t> seen = counts_of(grid, rows.looked_at());
    const CodeLength code = code_length(rows, seen);
    Measures measures;
    measures.raw = raw_bits(grid);
    measures.alone = entropy_of(seen);
    measures.bits = code.best.bits;
    measures.low = std::max(0.0, std::min({code.best.learnt, code.best.bits, code.least}) - code.doubt);
    measures.high = std::min(measures.raw, code.best.bits + code.doubt);
    measures.counted = rows.share();
    measures.spatial = code.spatial.bits;
    const double alone = measures.alone.corrected * static_cast<double>(grid.count());
    if (alone > 0) measures.topology = 1 - code.spatial.bits / alone;
    if (felt_error) measures.felt = std::min(measures.bits, felt_bits(grid, *felt_error));
    return measures;
}

}  // namespace tactics
