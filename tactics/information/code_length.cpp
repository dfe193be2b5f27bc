// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/code_length.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <thread>

#include "tactics/information/entropy.h"

namespace tactics {

namespace {

constexpr std::size_t kCounters = 1 << 18, kCountersOfCell = 4;
constexpr std::size_t kRoughness = 16;  // classes
constexpr std::size_t kShared = 1'000'000;
constexpr std::size_t kSampled = 300'000;
constexpr int kPad = 2;  // cells beside a row

// A neighbour that comes before: so many rows up, 3 the row of the slice before, and columns to the side. Nearest first.
struct Neighbour {
    int up, aside;
};
constexpr Neighbour kFlat[] = {{0, -1}, {1, 0}, {1, -1}, {1, 1}, {0, -2}, {2, 0}, {1, 2}, {1, -2}, {2, -1}, {2, 1}};
constexpr Neighbour kSolid[] = {{3, 0}, {0, -1}, {1, 0}, {1, -1}, {1, 1}, {3, 1}, {3, -1}, {0, -2}, {2, 0}, {1, 2}};

// The values that occur, numbered from 0: a picture of two greys is a picture of two levels.
struct Ranks {
    std::vector<std::uint16_t> of;
    int levels = 0;
    double bits = 0;  // to say which occur
};

Ranks ranks_of(const std::vector<std::uint64_t>& counts) {
    const auto levels = static_cast<double>(counts.size());
    const auto seen = static_cast<double>(std::count_if(counts.begin(), counts.end(), [](auto count) { return count > 0; }));
    Ranks ranks{std::vector<std::uint16_t>(counts.size()), 0, 0};
    if (seen > levels / 4 && levels > 16) {  // it would cost about as much as it saves
        for (std::size_t i = 0; i < counts.size(); ++i) ranks.of[i] = static_cast<std::uint16_t>(i);
        ranks.levels = static_cast<int>(counts.size());
        return ranks;
    }
    for (std::size_t i = 0; i < counts.size(); ++i) {
        ranks.of[i] = static_cast<std::uint16_t>(ranks.levels);
        ranks.levels += counts[i] > 0;
    }
    ranks.bits = (std::lgamma(levels + 1) - std::lgamma(seen + 1) - std::lgamma(levels - seen + 1)) / std::numbers::ln2;
    return ranks;
}

// How an error of prediction, modulo the levels, is counted: its class, and how many bits tell where in that it is.
struct ErrorClasses {
    std::vector<std::uint16_t> of;
    std::vector<int> rest;  // bits, of each class
};

ErrorClasses error_classes(int levels) {
    ErrorClasses classes{std::vector<std::uint16_t>(static_cast<std::size_t>(levels)), {}};
    constexpr int kExact = 16, kEighths = 8;
    for (int error = 0; error < levels; ++error) {
        const bool below = error > levels / 2;
        const int size = below ? levels - error : error;
        int at = error, bits = 0;
        if (levels > 256) {
            const int octave = size < kExact ? 0 : static_cast<int>(std::bit_width(static_cast<unsigned>(size))) - 4;
            bits = std::max(0, octave);
            at = size < kExact ? size : kExact + (octave - 1) * kEighths + (size >> octave) - kEighths;
            at = 2 * at + below;
        }
        classes.of[static_cast<std::size_t>(error)] = static_cast<std::uint16_t>(at);
        if (classes.rest.size() <= static_cast<std::size_t>(at)) classes.rest.resize(static_cast<std::size_t>(at) + 1);
        classes.rest[static_cast<std::size_t>(at)] = bits;
    }
    return classes;
}

// What is counted of a part of the rows; parts are added up.
struct Counts {
    std::vector<std::uint32_t> near;    // by the neighbours, the nearest counting least, then by the value
    std::vector<std::uint32_t> errors;  // by roughness, then by class
    std::vector<std::uint32_t> odd;     // of these, on the way

    void add(const Counts& other) {
        std::transform(near.begin(), near.end(), other.near.begin(), near.begin(), std::plus<>());
        std::transform(errors.begin(), errors.end(), other.errors.begin(), errors.begin(), std::plus<>());
    }
};

int clamped_median(int a, int b, int c) { return std::max(std::min(a, b), std::min(std::max(a, b), c)); }

using Small = std::int16_t;
Small sum(Small a, Small b) { return static_cast<Small>(a + b); }
Small difference(Small a, Small b) { return static_cast<Small>(a - b); }
Small distance(Small a, Small b) { return static_cast<Small>(a > b ? a - b : b - a); }
Small less(Small a, Small b) { return a < b ? a : b; }
Small more(Small a, Small b) { return a > b ? a : b; }

// Where each error of a row is counted, by roughness and then by the error itself: of up to 256 levels everything fits into 16
// bits, and without branches a compiler works on eight at a time.
void find_small_errors(const std::uint16_t* row, const std::uint16_t* up, int columns, Small levels,
                       std::uint16_t* __restrict places) {
    for (int x = 0; x < columns; ++x) {
        const auto left = static_cast<Small>(row[x - 1]), above = static_cast<Small>(up[x]),
                   corner = static_cast<Small>(up[x - 1]), right = static_cast<Small>(up[x + 1]);
        const Small slope = difference(sum(left, above), corner);
        const Small error = difference(static_cast<Small>(row[x]), more(less(left, above), less(more(left, above), slope)));
        const Small rough = sum(sum(distance(left, corner), distance(above, corner)), distance(above, right));
        // Its width in bits: it is at most 3 * 255.
        const auto width = static_cast<Small>((rough > 0) + (rough > 1) + (rough > 3) + (rough > 7) + (rough > 15) +
                                              (rough > 31) + (rough > 63) + (rough > 127) + (rough > 255) + (rough > 511));
        const Small wrapped = sum(error, error < 0 ? levels : Small{0});
        places[x] = static_cast<std::uint16_t>(sum(static_cast<Small>(width * levels), wrapped));
    }
}

class Counting {
public:
    Counting(const LevelGrid& grid, const Ranks& ranks)
        : grid_(grid), ranks_(ranks), levels_(static_cast<std::size_t>(ranks.levels)), classes_(error_classes(ranks.levels)) {
        const auto all = grid.slices > 1 ? std::span<const Neighbour>(kSolid) : std::span<const Neighbour>(kFlat);
        std::size_t counters = levels_, used = 0;
        const std::size_t most = std::min(kCounters, kCountersOfCell * grid.count());  // more have nothing to learn from
        for (; used < all.size() && counters * levels_ <= most; ++used) counters *= levels_;
        neighbours_ = all.first(used);
    }

    // What a sample of its rows says that the exact value of a neighbour does not pay beside prediction is not counted of all.
    void leave_what_does_not_pay() {
        const std::size_t rows = static_cast<std::size_t>(grid_.rows),
                          sampled = kSampled / static_cast<std::size_t>(grid_.columns);
        if (neighbours_.size() != 1 || grid_.slices > 1 || rows < 8 * sampled) return;
        const std::size_t first = (rows - sampled) / 2;
        const Counts counts = count(first, first + sampled);
        if (adaptive_code(counts.near, levels_).learnt > adaptive_code(counts.errors, classes_.rest.size()).learnt)
            neighbours_ = {};
    }

    std::size_t neighbours() const { return neighbours_.size(); }
    std::size_t levels() const { return levels_; }
    const ErrorClasses& classes() const { return classes_; }

    Counts count(std::size_t first, std::size_t end) const {
        Counts counts;
        std::size_t counters = levels_;
        for (std::size_t i = 0; i < neighbours_.size(); ++i) counters *= levels_;
        if (!neighbours_.empty()) counts.near.resize(counters);
        counts.errors.resize(kRoughness * classes_.rest.size());
        counts.odd.resize(counts.errors.size());
        std::vector<std::uint16_t> places(static_cast<std::size_t>(grid_.columns));
        // The row itself, the two before it, and that of the slice before.
        const auto width = static_cast<std::size_t>(grid_.columns) + 2 * kPad;
        std::vector<std::uint16_t> rows[4] = {std::vector<std::uint16_t>(width), std::vector<std::uint16_t>(width),
                                              std::vector<std::uint16_t>(width), std::vector<std::uint16_t>(width)};
        if (first > 0) load(rows[1], first - 1);
        if (first > 1) load(rows[2], first - 2);
        for (std::size_t y = first; y < end; ++y) {
            const auto slice = static_cast<std::size_t>(grid_.rows);
            if (grid_.slices > 1 && y < slice) rows[3] = rows[1];
            if (grid_.slices > 1 && y >= slice) load(rows[3], y - slice);
            load(rows[0], y);
            std::fill_n(rows[0].begin(), kPad, rows[1][kPad]);  // who reads it does not know the row yet
            const std::uint16_t* at[4];
            for (std::size_t i = 0; i < 4; ++i) at[i] = rows[i].data() + kPad;
            if (neighbours_.size() == 1)
                count_pairs(at[0], counts);
            else if (!neighbours_.empty())
                count_near(at, counts);
            if (grid_.slices > 1)
                count_errors<true>(at, counts);
            else if (levels_ <= 256)
                count_small_errors(at[0], at[1], counts, places);
            else
                count_errors<false>(at, counts);
            std::fill_n(rows[0].begin(), kPad, rows[0][kPad]);
            std::swap(rows[2], rows[1]);
            std::swap(rows[1], rows[0]);
        }
        std::transform(counts.errors.begin(), counts.errors.end(), counts.odd.begin(), counts.errors.begin(), std::plus<>());
        return counts;
    }

private:
    void load(std::vector<std::uint16_t>& to, std::size_t y) const {
        const auto columns = static_cast<std::size_t>(grid_.columns);
        const bool same = levels_ == ranks_.of.size();
        grid_.values.visit([&](const auto* values) {
            const auto* from = values + y * columns;
            if (same) std::copy_n(from, columns, to.begin() + kPad);
            if (!same) std::transform(from, from + columns, to.begin() + kPad, [&](auto value) { return ranks_.of[value]; });
        });
        std::fill_n(to.begin(), kPad, to[kPad]);
        std::fill_n(to.end() - kPad, kPad, to[columns + kPad - 1]);
    }

    void count_pairs(const std::uint16_t* row, Counts& counts) const {
        std::uint32_t* const near = counts.near.data();
        for (int x = 0; x < grid_.columns; ++x) ++near[row[x - 1] * levels_ + row[x]];
    }

    void count_near(const std::uint16_t* const (&rows)[4], Counts& counts) const {
        std::uint32_t* const near = counts.near.data();
        for (int x = 0; x < grid_.columns; ++x) {
            std::size_t at = 0;
            for (std::size_t i = neighbours_.size(); i-- > 0;)
                at = at * levels_ + rows[neighbours_[i].up][x + neighbours_[i].aside];
            ++near[at * levels_ + rows[0][x]];
        }
    }

    // The same as count_errors, of pictures of up to 256 levels. Two tables, as neighbours are often equal, and one would wait
    // for itself.
    void count_small_errors(const std::uint16_t* row, const std::uint16_t* up, Counts& counts,
                            std::vector<std::uint16_t>& places) const {
        const auto columns = static_cast<std::size_t>(grid_.columns);
        find_small_errors(row, up, grid_.columns, static_cast<Small>(levels_), places.data());
        const std::uint16_t* const at = places.data();
        std::uint32_t *const even = counts.errors.data(), *const odd = counts.odd.data();
        for (std::size_t x = 0; x + 1 < columns; x += 2) {
            ++even[at[x]];
            ++odd[at[x + 1]];
        }
        if (columns % 2 == 1) ++even[at[columns - 1]];
    }

    template <bool kVoxels>
    void count_errors(const std::uint16_t* const (&rows)[4], Counts& counts) const {
        std::uint32_t* const errors = counts.errors.data();
        const std::size_t width = classes_.rest.size();
        const std::uint16_t* const class_of = classes_.of.data();
        const auto levels = static_cast<int>(levels_);
        const std::uint16_t *const row = rows[0], *const up = rows[1];
        for (int x = 0; x < grid_.columns; ++x) {
            const int left = row[x - 1], above = up[x], corner = up[x - 1];
            int predicted = clamped_median(left, above, left + above - corner);
            int rough = std::abs(left - corner) + std::abs(above - corner) + std::abs(above - up[x + 1]);
            if constexpr (kVoxels) {
                predicted = clamped_median(left, above, rows[3][x]);
                rough += std::abs(rows[3][x] - above);
            }
            int error = row[x] - predicted;
            error += error < 0 ? levels : 0;
            const auto roughness = std::min<std::size_t>(kRoughness - 1, std::bit_width(static_cast<unsigned>(rough)));
            ++errors[roughness * width + class_of[error]];
        }
    }

    const LevelGrid& grid_;
    const Ranks& ranks_;
    std::size_t levels_;
    ErrorClasses classes_;
    std::span<const Neighbour> neighbours_;
};

Counts count_all(const Counting& counting, const LevelGrid& grid) {
    const auto rows = static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.slices);
    if (grid.count() < kShared || rows < 2) return counting.count(0, rows);
    Counts upper, lower;
    {
        const std::jthread other([&] { upper = counting.count(0, rows / 2); });
        lower = counting.count(rows / 2, rows);
    }
    lower.add(upper);
    return lower;
}

void take_shorter(Code& best, const Code& code) {
    if (code.bits < best.bits) best = code;
}

}  // namespace

CodeLength code_length(const LevelGrid& grid) { return code_length(grid, counts_of(grid)); }

CodeLength code_length(const LevelGrid& grid, const std::vector<std::uint64_t>& seen) {
    check_grid(grid);
    const Ranks ranks = ranks_of(seen);
    std::vector<std::uint32_t> occurring(static_cast<std::size_t>(ranks.levels));
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i] > 0) occurring[ranks.of[i]] = static_cast<std::uint32_t>(seen[i]);
    Counting counting(grid, ranks);
    counting.leave_what_does_not_pay();
    Counts counts = count_all(counting, grid);

    CodeLength length;
    length.alone = adaptive_code(occurring, occurring.size());
    length.spatial = adaptive_code(counts.errors, counting.classes().rest.size());
    for (std::size_t i = 0; i < counts.errors.size(); ++i) {
        const double rest = counts.errors[i] * counting.classes().rest[i % counting.classes().rest.size()];
        length.spatial.bits += rest;
        length.spatial.learnt += rest;
    }
    // Of fewer neighbours the counts are those of more, added up.
    const std::size_t levels = counting.levels();
    for (std::size_t used = counting.neighbours(); used > 0; --used) {
        take_shorter(length.spatial, adaptive_code(counts.near, levels));
        const std::size_t fewer = counts.near.size() / levels;
        for (std::size_t i = fewer; i < counts.near.size(); ++i) counts.near[i % fewer] += counts.near[i];
        counts.near.resize(fewer);
    }
    // Which code it is has to be said, too.
    const double said = ranks.bits + std::log2(static_cast<double>(counting.neighbours() + 3));
    length.alone.bits += said;
    length.spatial.bits += said;
    length.best = {raw_bits(grid), length.alone.learnt};
    take_shorter(length.best, length.alone);
    take_shorter(length.best, length.spatial);
    return length;
}

}  // namespace tactics
