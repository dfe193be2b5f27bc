// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/entropy.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tactics {

namespace {

constexpr std::size_t kTable = 1 << 20;  // pairs of levels that are counted in a table; more are sorted

std::vector<std::uint64_t> counts_of_pairs(const LevelGrid& first, const LevelGrid& second) {
    const auto levels = static_cast<std::size_t>(second.levels);
    const std::size_t pairs = static_cast<std::size_t>(first.levels) * levels;
    if (pairs <= kTable) {
        std::vector<std::uint64_t> counts(pairs);
        for (std::size_t i = 0; i < first.count(); ++i) ++counts[first.values[i] * levels + second.values[i]];
        return counts;
    }
    std::vector<std::uint32_t> sorted(first.count());
    for (std::size_t i = 0; i < sorted.size(); ++i)
        sorted[i] = static_cast<std::uint32_t>(first.values[i]) << 16 | second.values[i];
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::uint64_t> counts;
    for (std::size_t from = 0, to = 0; from < sorted.size(); from = to) {
        while (to < sorted.size() && sorted[to] == sorted[from]) ++to;
        counts.push_back(to - from);
    }
    return counts;
}

}  // namespace

Entropy entropy_of(std::span<const std::uint64_t> counts) {
    Entropy entropy;
    std::uint64_t all = 0;
    for (const std::uint64_t count : counts) {
        if (count == 0) continue;
        ++entropy.distinct;
        all += count;
    }
    if (all == 0) return entropy;
    const auto n = static_cast<double>(all), distinct = static_cast<double>(entropy.distinct);
    for (const std::uint64_t count : counts)
        if (count > 0) entropy.plug_in += static_cast<double>(count) / n * std::log2(n / static_cast<double>(count));
    entropy.corrected = std::min(std::log2(distinct), entropy.plug_in + (distinct - 1) / (2 * n * std::numbers::ln2));
    return entropy;
}

std::vector<std::uint64_t> counts_of(const LevelGrid& grid) {
    const RowRange all(0, grid.count() / static_cast<std::size_t>(grid.columns));
    return counts_of(grid, {&all, 1});
}

std::vector<std::uint64_t> counts_of(const LevelGrid& grid, std::span<const RowRange> rows) {
    std::vector<std::uint64_t> counts(static_cast<std::size_t>(grid.levels));
    // Four tables: neighbours are often equal, and one would wait for itself.
    std::vector<std::uint32_t> tables[4];
    for (auto& table : tables) table.resize(counts.size());
    grid.values.visit([&](const auto* values) {
        for (const auto& [first, last] : rows) {
            const auto columns = static_cast<std::size_t>(grid.columns);
            std::size_t i = first * columns;
            for (; i + 4 <= last * columns; i += 4)
                for (std::size_t k = 0; k < 4; ++k) ++tables[k][values[i + k]];
            for (; i < last * columns; ++i) ++tables[0][values[i]];
        }
    });
    for (const auto& table : tables)
        for (std::size_t value = 0; value < counts.size(); ++value) counts[value] += table[value];
    return counts;
}

Entropy entropy_of(const LevelGrid& grid) { return entropy_of(counts_of(grid)); }

double JointEntropy::conditional() const { return std::max(0.0, joint.corrected - second.corrected); }
double JointEntropy::mutual() const { return std::max(0.0, first.corrected + second.corrected - joint.corrected); }

JointEntropy joint_entropy(const LevelGrid& first, const LevelGrid& second) {
    if (first.columns != second.columns || first.rows != second.rows || first.slices != second.slices)
        throw std::logic_error("two grids of other shapes have no joint entropy");
    return {entropy_of(first), entropy_of(second), entropy_of(counts_of_pairs(first, second))};
}

}  // namespace tactics
