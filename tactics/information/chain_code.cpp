// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/chain_code.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace tactics {

namespace {

constexpr std::size_t kMostOrder = 10;

// Calls take(how many are before it, at most the order; where its counter is) of each cell of those rows.
template <typename Take>
void walk(const ChainCells& cells, std::size_t order, bool restarts, RowRange part, const Take& take) {
    std::size_t top = 1;
    for (std::size_t i = 1; i < order; ++i) top *= cells.levels;
    std::vector<std::uint8_t> line(order + cells.columns);  // a row, and what comes before it
    std::uint8_t* const row = line.data() + order;
    const std::size_t ahead = restarts ? 0 : std::min(part.first, (order + cells.columns - 1) / cells.columns);
    for (std::size_t y = part.first - ahead; y < part.second; ++y) {
        std::copy(line.end() - static_cast<std::ptrdiff_t>(order), line.end(), line.begin());
        cells.load(row, y);
        if (y < part.first || !cells.counts(y)) continue;
        const std::size_t behind = restarts ? 0 : std::min(order, y * cells.columns);  // of earlier rows
        std::size_t context = 0;
        for (std::size_t i = behind; i > 0; --i) context = context * cells.levels + *(row - i);
        for (std::size_t x = 0; x < cells.columns; ++x) {
            const std::size_t before = std::min(order, behind + x), at = context * cells.levels + row[x];
            take(before, at);
            context = before < order ? at : (context - top * *(row + x - order)) * cells.levels + row[x];
        }
    }
}

Code code_of(const ChainCounts& counts, std::size_t levels) {
    Code code = adaptive_code(counts.main, levels);
    for (const auto& begin : counts.begins) code += adaptive_code(begin, levels);
    return code;
}

// Of a shorter memory the counts are those of a longer one, added up.
void forget_farthest(ChainCounts& counts) {
    const std::size_t fewer = counts.begins.back().size();
    add_up(counts.main, fewer);
    std::transform(counts.main.begin(), counts.main.end(), counts.begins.back().begin(), counts.main.begin(), std::plus<>());
    counts.begins.pop_back();
    --counts.order;
}

}  // namespace

ChainCode shortest_chain(const ChainCells& cells, std::size_t most) {
    ChainCode best{{std::numeric_limits<double>::max(), 0, 0, 0}, {}, {}};
    ChainCounts counts{0, true, {}, {}};
    std::size_t counters = cells.levels;
    for (; counts.order < kMostOrder && counters * cells.levels <= most; ++counts.order) counters *= cells.levels;
    if (counts.order == 0) return best;
    const std::size_t longest = counts.order, rows = cells.rows;
    for (const bool restarts : {true, false}) {
        counts = {longest, restarts, std::vector<std::uint32_t>(counters), {}};
        for (std::size_t i = 0, size = cells.levels; i < longest; ++i, size *= cells.levels) counts.begins.emplace_back(size);
        walk(cells, longest, restarts, {0, rows},
             [&](std::size_t before, std::size_t at) { ++(before < longest ? counts.begins[before] : counts.main)[at]; });
        for (;; forget_farthest(counts)) {
            const Code code = code_of(counts, cells.levels);
            best.tried.push_back(code);
            if (code.bits < best.code.bits) {
                best.code = code;
                best.counts = counts;
            }
            if (counts.order == 1) break;
        }
        if (rows == 1) break;
    }
    return best;
}

void tell_costs(const ChainCells& cells, const ChainCounts& counts, std::span<const RowRange> parts, const TakeCosts& take) {
    const std::vector<float> main = costs_of(counts.main, cells.levels);
    std::vector<std::vector<float>> begins;
    for (const auto& begin : counts.begins) begins.push_back(costs_of(begin, cells.levels));
    std::vector<float> row;
    for (const RowRange& part : parts)
        walk(cells, counts.order, counts.restarts, part, [&](std::size_t before, std::size_t at) {
            row.push_back((before < counts.order ? begins[before] : main)[at]);
            if (row.size() < cells.columns) return;
            take(row);
            row.clear();
        });
}

}  // namespace tactics
