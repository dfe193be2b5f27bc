// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/measures.h"

#include <algorithm>

#include "tactics/information/code_length.h"
#include "tactics/information/felt_rate.h"

namespace tactics {

Measures measure(const LevelGrid& grid, std::optional<double> felt_error) {
    const std::vector<std::uint64_t> seen = counts_of(grid);
    const CodeLength code = code_length(grid, seen);
    Measures measures;
    measures.raw = raw_bits(grid);
    measures.alone = entropy_of(seen);
    measures.low = std::min(code.best.learnt, code.best.bits);
    measures.high = code.best.bits;
    measures.spatial = code.spatial.bits;
    const double alone = measures.alone.corrected * static_cast<double>(grid.count());
    if (alone > 0) measures.topology = 1 - code.spatial.bits / alone;
    if (felt_error) measures.felt = std::min(measures.high, felt_bits(grid, *felt_error));
    return measures;
}

}  // namespace tactics
