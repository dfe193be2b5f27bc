// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/code_length.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>

#include "tactics/information/chain_code.h"
#include "tactics/information/entropy.h"
#include "tactics/information/neighbour_counts.h"
#include "tactics/information/repeats.h"

namespace tactics {

namespace {

constexpr std::size_t kChainLevels = 64;
constexpr double kDeviations = 3;
// Of an event that was seen n times, up to n + d^2 / 2 + d sqrt(n + d^2 / 4) are to be expected, to d deviations (E. B. Wilson,
// 1927). So a grid of the same source may have d^2 / 2 cells that nothing in this one foretells.
constexpr double kUnforeseen = kDeviations * kDeviations / 2;
double unforeseen_cell(const CountedRows& rows) { return std::log2(rows.cells()); }

// The bits of cells that come one after the other: how they vary, alone and in parts of so many.
class CellBits {
public:
    explicit CellBits(std::size_t part) : part_(std::max<std::size_t>(1, part)) {}

    void add(std::span<const float> costs) {
        while (!costs.empty()) {
            const auto piece = costs.first(std::min(costs.size(), part_ - filled_));
            add_piece(piece);
            costs = costs.subspan(piece.size());
            if (filled_ < part_) continue;
            if (parts_++ > 0) steps_ += (open_ - before_) * (open_ - before_);
            before_ = open_;
            open_ = 0;
            filled_ = 0;
        }
    }

    // The variance of the bits of a cell such that the variance of their sum is as many times that: as if cells were
    // independent, or by sums over parts, which see what goes on from cell to cell; whichever is more. A part is compared with
    // the next (J. von Neumann 1941), so that what changes slowly over the grid counts little.
    double variance() const {
        const double mean = sum_ / cells_, alone = std::max(0.0, squares_ / cells_ - mean * mean);
        if (part_ < 2 || parts_ < 2) return alone;
        return std::max(alone, steps_ / static_cast<double>(parts_ - 1) / 2 / static_cast<double>(part_));
    }

private:
    // A compiler works on four at a time. The sums of so many are exact enough in single precision.
    void add_piece(std::span<const float> costs) {
        constexpr std::size_t kSums = 4, kExact = 1024;
        for (; costs.size() > kExact; costs = costs.subspan(kExact)) add_piece(costs.first(kExact));
        float sums[kSums] = {}, squares[kSums] = {};
        std::size_t i = 0;
        for (; i + kSums <= costs.size(); i += kSums)
            for (std::size_t k = 0; k < kSums; ++k) {
                sums[k] += costs[i + k];
                squares[k] += costs[i + k] * costs[i + k];
            }
        for (; i < costs.size(); ++i) {
            sums[0] += costs[i];
            squares[0] += costs[i] * costs[i];
        }
        const double sum = std::accumulate(std::begin(sums), std::end(sums), 0.0);
        sum_ += sum;
        open_ += sum;
        squares_ += std::accumulate(std::begin(squares), std::end(squares), 0.0);
        cells_ += static_cast<double>(costs.size());
        filled_ += costs.size();
    }

    std::size_t part_, filled_ = 0, parts_ = 0;  // cells of each part and of the last, and whole parts
    double sum_ = 0, squares_ = 0, cells_ = 0;
    double open_ = 0, before_ = 0, steps_ = 0;  // of the last part and the one before, and squares of their differences
};

// The codes of a grid, each tried once, with what the shortest one takes for each cell.
class Codes {
public:
    Codes(const CountedRows& rows, const std::vector<std::uint64_t>& seen, bool with_chains)
        : rows_(rows), ranks_(ranks_of(seen)), occurring_(static_cast<std::size_t>(ranks_.levels)), counting_(rows, ranks_) {
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (seen[i] > 0) occurring_[ranks_.of[i]] = static_cast<std::uint32_t>(seen[i]);
        try_all(with_chains);
    }

    const Code& alone() const { return alone_; }
    const Code& least() const { return least_; }
    const Code& spatial() const { return spatial_; }

    // How the bits of cells vary, by the spatial code or by that of the levels alone.
    CellBits bits_of(bool spatial) const {
        const LevelGrid& grid = rows_.whole();
        const std::vector<RowRange> parts = parts_read(spatial);
        const auto width = static_cast<std::size_t>(spatial && down_ ? grid.rows : grid.columns);
        std::size_t cells = 0;
        for (const RowRange& part : parts) cells += (part.second - part.first) * width;
        constexpr std::size_t kParts = 64;
        CellBits bits(cells / (parts.size() > 1 ? parts.size() : kParts));
        tell_costs(spatial, parts, [&bits](std::span<const float> costs) { bits.add(costs); });
        return bits;
    }

private:
    std::size_t width() const { return counting_.classes().rest.size(); }

    void try_all(bool with_chains) {
        NeighbourCounts counts = counting_.count_all();
        alone_ = adaptive_code(occurring_, occurring_.size());
        const double looked_at = static_cast<double>(rows_.cells_there()) / rows_.cells();  // the levels of all rows
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
        if (with_chains) try_chains();
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
            add_up(near, fewer);
        }
    }

    void try_chains() {
        const LevelGrid& grid = rows_.whole();
        if (counting_.levels() < 2 || counting_.levels() > kChainLevels || grid.slices != 1) return;
        try_chain(rows_as_chain(), false);
        if (rows_.share() == 1 && grid.rows > 1) try_chain(columns_as_chain(), true);
    }

    void try_chain(const ChainCells& cells, bool down) {
        ChainCode chain = shortest_chain(cells, most_counters(rows_.cells_there()));
        for (const Code& code : chain.tried) reckon(code);
        if (chain.code.bits >= spatial_.bits) return;
        spatial_ = chain.code;
        chain_ = std::move(chain.counts);
        down_ = down;
    }

    ChainCells rows_as_chain() const {
        const auto columns = static_cast<std::size_t>(rows_.whole().columns);
        const auto load = [this, row = std::vector<std::uint16_t>(columns)](std::uint8_t* to, std::size_t y) mutable {
            counting_.load(row.data(), y);
            std::transform(row.begin(), row.end(), to, [](std::uint16_t value) { return static_cast<std::uint8_t>(value); });
        };
        return {rows_.rows(), columns, counting_.levels(), load, [this](std::size_t row) { return rows_.counts(row); }};
    }

    // Of a grid that is counted whole. So many columns are read at a time: neighbours in memory.
    ChainCells columns_as_chain() const {
        constexpr std::size_t kStrip = 64;
        const auto columns = static_cast<std::size_t>(rows_.whole().columns), rows = static_cast<std::size_t>(rows_.whole().rows);
        const auto load = [=, this, strip = std::vector<std::uint8_t>(), first = columns](std::uint8_t* to,
                                                                                          std::size_t x) mutable {
            if (x < first || x >= first + kStrip || strip.empty()) {
                first = x;
                strip.resize(kStrip * rows);
                counting_.load_columns(strip.data(), x, std::min(kStrip, columns - x));
            }
            std::copy_n(strip.begin() + static_cast<std::ptrdiff_t>((x - first) * rows), rows, to);
        };
        return {columns, rows, counting_.levels(), load, [](std::size_t) { return true; }};
    }

    // Parts of what the spatial code or that of the levels alone reads row by row, or column by column.
    std::vector<RowRange> parts_read(bool spatial) const {
        return spatial && down_
                   ? parts_of(static_cast<std::size_t>(rows_.whole().columns), static_cast<std::size_t>(rows_.whole().rows))
                   : rows_.parts();
    }

    void tell_costs(bool spatial, const std::vector<RowRange>& parts, const TakeCosts& take) const {
        if (!spatial) return tell_alone_costs(parts, take);
        if (chain_) return tactics::tell_costs(down_ ? columns_as_chain() : rows_as_chain(), *chain_, parts, take);
        if (used_ > 0) return counting_.tell_near_costs(costs_of(best_near_, counting_.levels()), used_, parts, take);
        std::vector<float> costs = costs_of(errors_, width());
        for (std::size_t i = 0; i < costs.size(); ++i) costs[i] += static_cast<float>(counting_.classes().rest[i % width()]);
        counting_.tell_error_costs(costs, parts, take);
    }

    void tell_alone_costs(std::span<const RowRange> parts, const TakeCosts& take) const {
        const std::vector<float> costs = costs_of(occurring_, occurring_.size());
        std::vector<std::uint16_t> row(static_cast<std::size_t>(rows_.whole().columns));
        std::vector<float> found(row.size());
        for (const RowRange& part : parts)
            for (std::size_t y = part.first; y < part.second; ++y) {
                counting_.load(row.data(), y);
                std::transform(row.begin(), row.end(), found.begin(), [&](std::uint16_t value) { return costs[value]; });
                take(found);
            }
    }

    const CountedRows& rows_;
    Ranks ranks_;
    std::vector<std::uint32_t> occurring_;
    NeighbourCounting counting_;
    Code alone_, spatial_;
    Code least_;
    std::vector<std::uint32_t> errors_, best_near_;
    std::size_t used_ = 0;              // neighbours of the best code; 0: it predicts, or
    std::optional<ChainCounts> chain_;  // it is a chain
    bool down_ = false;                 // of the columns
};

// CodeLength::doubt of what is written by the spatial code or by the levels alone.
double doubt_of(const Codes& codes, bool spatial, const CountedRows& rows) {
    // A share that was learnt fits its own grid better than the true one does, by half a nat on average, with a deviation of 0.7
    // (S. S. Wilks, 1938).
    const double cell = unforeseen_cell(rows), variance = codes.bits_of(spatial).variance() * rows.cells() +
                                                          kUnforeseen / 2 * cell * cell +
                                                          codes.least().free / (2 * std::numbers::ln2 * std::numbers::ln2);
    return (kDeviations * std::sqrt(variance) + kUnforeseen * cell) / rows.share();
}

CodeLength length_of_parts(std::span<const LevelGrid> parts, bool with_doubt);

// What a grid follows from, instead of the grid, and so many bits that say how. Another grid of its source may still have cells
// that break the rule.
void take_if_shorter(CodeLength& length, const CodeLength& source, double said, const CountedRows& rows) {
    if (source.best.bits + said >= length.best.bits) return;
    length.best = source.best;
    length.best.bits += said;
    length.least = std::min(length.least, source.least);
    length.doubt = source.doubt + kUnforeseen * unforeseen_cell(rows);
}

CodeLength length_of(const CountedRows& rows, const std::vector<std::uint64_t>& seen, bool with_doubt) {
    const Codes codes(rows, seen, true);
    const double share = rows.share();
    const auto of_whole = [share](const Code& code) {
        return Code{code.bits / share, code.learnt / share, code.free, code.corrected / share};
    };
    CodeLength length{{}, of_whole(codes.alone()), of_whole(codes.spatial()), codes.least().corrected / share};
    const bool spatial = length.spatial.bits < length.alone.bits;
    length.best = spatial ? length.spatial : length.alone;
    if (with_doubt) length.doubt = doubt_of(codes, spatial, rows) + rows.unlike() * length.best.bits;
    if (const auto small = reduced(rows.whole()))
        take_if_shorter(length, length_of_parts({&small->grid, 1}, with_doubt), small->said, rows);
    if (const auto shift = rows.shift()) {
        constexpr double kShifts = (2 * kMostShift + 1) * (kMostShift + 1);
        take_if_shorter(length, length_of_parts(borders_of(rows.whole(), *shift), with_doubt), std::log2(kShifts), rows);
    }
    if (const double raw = raw_bits(rows.cells() / share, rows.whole().levels); raw < length.best.bits)
        length.best = {raw, std::min(raw, length.alone.learnt), 0, raw};
    return length;
}

// Of all of them, one after the other.
CodeLength length_of_parts(std::span<const LevelGrid> parts, bool with_doubt) {
    CodeLength sum;
    for (const LevelGrid& part : parts) {
        const CountedRows rows(part);
        const CodeLength one = length_of(rows, counts_of(part, rows.looked_at()), with_doubt);
        sum.best += one.best;
        sum.least += one.least;
        sum.doubt += one.doubt;
    }
    return sum;
}

}  // namespace

CodeLength code_length(const LevelGrid& grid) {
    check_grid(grid);
    const CountedRows rows(grid);
    return length_of(rows, counts_of(grid, rows.looked_at()), false);
}

double neighbour_bits(const LevelGrid& grid) {
    const CountedRows rows(grid);
    const Codes codes(rows, counts_of(grid, rows.looked_at()), false);
    return std::min(raw_bits(grid), std::min(codes.alone().bits, codes.spatial().bits) / rows.share());
}

CodeLength code_length(const CountedRows& rows, const std::vector<std::uint64_t>& seen) { return length_of(rows, seen, true); }

}  // namespace tactics
