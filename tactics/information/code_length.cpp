// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/code_length.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "tactics/information/chain_code.h"
#include "tactics/information/entropy.h"
#include "tactics/information/neighbour_counts.h"

namespace tactics {

namespace {

constexpr std::size_t kChainLevels = 64;
constexpr std::size_t kMostPeriod = 64;
constexpr double kDeviations = 3;
// Of what is seen n times, n + d^2 / 2 + d sqrt(n + d^2 / 4) may be in store, with d deviations (E. B. Wilson 1927); each time a
// cell that nobody can foresee.
constexpr double kUnforeseen = kDeviations * kDeviations / 2;
double unforeseen_cell(const CountedRows& rows) { return std::log2(rows.cells()); }

double mean_of(std::span<const double> values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

// The variance of the bits of a cell such that the variance of their sum is as many times that: as if cells were independent, or
// by sums over parts in a row, which see what goes on from cell to cell; whichever is more. A part is compared with the next (J.
// von Neumann 1941), so that what changes slowly over the grid counts little.
double variance_of(const std::vector<float>& costs, std::size_t parts) {
    const auto count = static_cast<double>(costs.size());
    double sum = 0, squares = 0;
    for (const float cost : costs) {
        sum += static_cast<double>(cost);
        squares += static_cast<double>(cost) * static_cast<double>(cost);
    }
    const double alone = std::max(0.0, squares / count - sum / count * (sum / count));
    const std::size_t size = costs.size() / parts;
    if (size < 2) return alone;
    std::vector<double> steps;
    double before = 0;
    for (std::size_t part = 0; part < parts; ++part) {
        double bits = 0;
        for (std::size_t i = part * size; i < (part + 1) * size; ++i) bits += static_cast<double>(costs[i]);
        if (part > 0) steps.push_back((bits - before) * (bits - before));
        before = bits;
    }
    return std::max(alone, mean_of(steps) / 2 / static_cast<double>(size));
}

// So many rows up all rows are the same; 0: there is no such number.
std::size_t period_of(const LevelGrid& grid) {
    const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows);
    if (grid.slices != 1) return 0;
    return grid.values.visit([&](const auto* values) -> std::size_t {
        const auto is_same = [&](std::size_t y, std::size_t period) {
            return std::equal(values + y * columns, values + (y + 1) * columns, values + (y - period) * columns);
        };
        for (std::size_t period = 1; period <= std::min(kMostPeriod, rows / 2); ++period) {
            bool repeats = true;
            constexpr std::size_t kLooks = 16;  // first here and there, as empty rows are often many
            for (std::size_t i = 0; repeats && i < kLooks; ++i)
                repeats = is_same(period + i * (rows - 1 - period) / (kLooks - 1), period);
            for (std::size_t y = period; repeats && y < rows; ++y) repeats = is_same(y, period);
            if (repeats) return period;
        }
        return 0;
    });
}

LevelGrid top_of(const LevelGrid& grid, std::size_t rows) {
    std::vector<std::uint16_t> values;
    for (std::size_t i = 0; i < rows * static_cast<std::size_t>(grid.columns); ++i) values.push_back(grid.values[i]);
    return {grid.columns, static_cast<int>(rows), 1, grid.levels, std::move(values)};
}

// The codes of a grid, each tried once, with what the shortest one takes for each cell.
class Codes {
public:
    // `columns`: chains down them are tried, too.
    Codes(const CountedRows& rows, const std::vector<std::uint64_t>& seen, bool columns)
        : rows_(rows), ranks_(ranks_of(seen)), occurring_(static_cast<std::size_t>(ranks_.levels)), counting_(rows, ranks_) {
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (seen[i] > 0) occurring_[ranks_.of[i]] = static_cast<std::uint32_t>(seen[i]);
        try_all(columns);
    }

    const Code& alone() const { return alone_; }
    const Code& least() const { return least_; }
    const Code& spatial() const { return spatial_; }

    // Bits of each cell, of the spatial code or of the levels alone.
    std::vector<float> costs(bool spatial) const {
        const std::vector<RowRange> parts = rows_.parts();
        if (!spatial) return alone_costs(parts);
        if (chain_) return chain_costs(parts);
        if (used_ > 0) return counting_.near_costs(costs_of(best_near_, counting_.levels()), used_, parts);
        std::vector<float> costs = costs_of(errors_, width());
        for (std::size_t i = 0; i < costs.size(); ++i) costs[i] += static_cast<float>(counting_.classes().rest[i % width()]);
        return counting_.error_costs(costs, parts);
    }

private:
    std::size_t width() const { return counting_.classes().rest.size(); }

    void try_all(bool columns) {
        NeighbourCounts counts = counting_.count_all();
        alone_ = adaptive_code(occurring_, occurring_.size());
        const double looked_at = static_cast<double>(rows_.grid().count()) / rows_.cells();  // the levels of all rows
        alone_ = {alone_.bits / looked_at, alone_.learnt / looked_at, alone_.free, alone_.corrected / looked_at};
        least_ = alone_;
        spatial_ = adaptive_code(counts.errors, width());
        for (std::size_t i = 0; i < counts.errors.size(); ++i) {
            const double rest = counts.errors[i] * counting_.classes().rest[i % width()];
            spatial_.bits += rest;
            spatial_.learnt += rest;
        }
        reckon(spatial_);
        errors_ = std::move(counts.errors);
        try_near(std::move(counts.near));
        try_chains(columns);
        // Which code it is has to be said, too.
        const double said = ranks_.bits + std::log2(static_cast<double>(counting_.neighbours() + 4));
        alone_.bits += said;
        spatial_.bits += said;
    }

    void reckon(const Code& code) {
        constexpr double kCellsOfShare = 4;
        if (kCellsOfShare * code.free <= rows_.cells() && code.corrected < least_.corrected) least_ = code;
    }

    // Of fewer neighbours the counts are those of more, added up.
    void try_near(std::vector<std::uint32_t> near) {
        const std::size_t levels = counting_.levels();
        for (std::size_t used = counting_.neighbours(); used > 0; --used) {
            const Code code = adaptive_code(near, levels);
            reckon(code);
            if (code.bits < spatial_.bits) {
                spatial_ = code;
                used_ = used;
                best_near_ = near;
            }
            const std::size_t fewer = near.size() / levels;
            for (std::size_t i = fewer; i < near.size(); ++i) near[i % fewer] += near[i];
            near.resize(fewer);
        }
    }

    void try_chains(bool down) {
        const LevelGrid& grid = rows_.grid();
        if (counting_.levels() < 2 || counting_.levels() > kChainLevels || grid.slices != 1) return;
        const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows);
        std::vector<std::uint16_t> cells(grid.count());
        for (std::size_t y = 0; y < rows; ++y) counting_.load(cells.data() + y * columns, y);
        std::vector<std::uint16_t> turned;
        if (down && rows_.share() == 1 && rows > 1)
            for (std::size_t x = 0; x < columns; ++x)
                for (std::size_t y = 0; y < rows; ++y) turned.push_back(cells[y * columns + x]);
        try_chain(std::move(cells), columns);
        if (!turned.empty()) try_chain(std::move(turned), rows);
    }

    void try_chain(std::vector<std::uint16_t> cells, std::size_t columns) {
        ChainCode chain = shortest_chain(chain_of(cells, columns), most_counters(cells.size()));
        for (const Code& code : chain.tried) reckon(code);
        if (chain.code.bits >= spatial_.bits) return;
        spatial_ = chain.code;
        chain_ = std::move(chain.counts);
        cells_ = std::move(cells);
        chain_columns_ = columns;
    }

    // Of a grid with rows that do not count there are chains along rows only.
    ChainCells chain_of(std::span<const std::uint16_t> cells, std::size_t columns) const {
        return {cells, columns, counting_.levels(), [this](std::size_t row) { return rows_.share() == 1 || rows_.counts(row); }};
    }

    std::vector<float> chain_costs(std::span<const RowRange> parts) const {
        const RowRange all = {0, cells_.size() / chain_columns_};
        const bool turned = chain_columns_ != static_cast<std::size_t>(rows_.grid().columns);
        return costs_of(chain_of(cells_, chain_columns_), *chain_, turned ? std::span(&all, 1) : parts);
    }

    std::vector<float> alone_costs(std::span<const RowRange> parts) const {
        const std::vector<float> costs = costs_of(occurring_, occurring_.size());
        std::vector<float> found;
        std::vector<std::uint16_t> row(static_cast<std::size_t>(rows_.grid().columns));
        for (const RowRange& part : parts)
            for (std::size_t y = part.first; y < part.second; ++y) {
                counting_.load(row.data(), y);
                for (const std::uint16_t value : row) found.push_back(costs[value]);
            }
        return found;
    }

    const CountedRows& rows_;
    Ranks ranks_;
    std::vector<std::uint32_t> occurring_;
    NeighbourCounting counting_;
    std::vector<std::uint16_t> cells_;  // of the chain, in its order
    std::size_t chain_columns_ = 0;
    Code alone_, spatial_;
    Code least_;
    std::vector<std::uint32_t> errors_, best_near_;
    std::size_t used_ = 0;              // neighbours of the best code; 0: it predicts, or
    std::optional<ChainCounts> chain_;  // it is a chain
};

// CodeLength::doubt of what is written by the spatial code or by the levels alone.
double doubt_of(const Codes& codes, bool spatial, const CountedRows& rows) {
    constexpr std::size_t kParts = 64;
    const std::size_t parts = rows.parts().size();
    const std::vector<float> costs = codes.costs(spatial);
    // What was learnt of a share is by chance too good by half a nat, with a deviation of 0.7 (S. S. Wilks 1938).
    const double cell = unforeseen_cell(rows), variance = variance_of(costs, parts > 1 ? parts : kParts) * rows.cells() +
                                                          kUnforeseen / 2 * cell * cell +
                                                          codes.least().free / (2 * std::numbers::ln2 * std::numbers::ln2);
    return (kDeviations * std::sqrt(variance) + kUnforeseen * cell) / rows.share();
}

CodeLength length_of(const CountedRows& rows, const std::vector<std::uint64_t>& seen, bool with_doubt) {
    const Codes codes(rows, seen, with_doubt);
    const double share = rows.share();
    const auto of_whole = [share](const Code& code) {
        return Code{code.bits / share, code.learnt / share, code.free, code.corrected / share};
    };
    CodeLength length{{}, of_whole(codes.alone()), of_whole(codes.spatial()), codes.least().corrected / share};
    const bool spatial = length.spatial.bits < length.alone.bits;
    length.best = spatial ? length.spatial : length.alone;
    if (with_doubt) length.doubt = doubt_of(codes, spatial, rows) + rows.unlike() * length.best.bits;
    if (const std::size_t period = period_of(rows.grid()); period > 0 && share == 1) {
        const double once = code_length(top_of(rows.grid(), period)).best.bits + std::log2(kMostPeriod);
        length.best = {std::min(length.best.bits, once), 0, 0, 0};
        length.least = 0;
        length.doubt = 2 * kUnforeseen * unforeseen_cell(rows);
    }
    if (const double raw = raw_bits(rows.cells() / share, rows.grid().levels); raw < length.best.bits)
        length.best = {raw, std::min(raw, length.alone.learnt), 0, raw};
    return length;
}

}  // namespace

CodeLength code_length(const LevelGrid& grid) {
    check_grid(grid);
    const CountedRows rows(grid);
    return length_of(rows, counts_of(rows.grid()), false);
}

CodeLength code_length(const CountedRows& rows, const std::vector<std::uint64_t>& seen) { return length_of(rows, seen, true); }

}  // namespace tactics
