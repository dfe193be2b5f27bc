// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/neighbour_counts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numbers>
#include <thread>
namespace tactics {

namespace {

constexpr std::size_t kRoughness = 16;  // classes
constexpr std::size_t kShared = 1'000'000;
constexpr std::size_t kSampled = 150'000;
constexpr int kPad = 2;  // cells beside a row

// Nearest first.
constexpr Neighbour kFlat[] = {{0, -1}, {1, 0}, {1, -1}, {1, 1}, {0, -2}, {2, 0}, {1, 2}, {1, -2}, {2, -1}, {2, 1}};
constexpr Neighbour kAbove[] = {{1, 0}};
constexpr Neighbour kSolid[] = {{3, 0}, {0, -1}, {1, 0}, {1, -1}, {1, 1}, {3, 1}, {3, -1}, {0, -2}, {2, 0}, {1, 2}};

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

// Counts all of them. Neighbours are often equal, and a counter would wait for itself: four at once are four, and else there are
// two tables in turn.
void count_places(const std::uint16_t* places, std::size_t count, std::uint32_t* even, std::uint32_t* odd) {
    constexpr std::uint64_t kFourTimes = 0x0001'0001'0001'0001;
    std::size_t x = 0;
    for (; x + 4 <= count; x += 4) {
        std::uint64_t four = 0;
        std::memcpy(&four, places + x, sizeof four);
        if (four == kFourTimes * places[x]) {
            even[places[x]] += 4;
            continue;
        }
        ++even[places[x]];
        ++odd[places[x + 1]];
        ++even[places[x + 2]];
        ++odd[places[x + 3]];
    }
    for (; x < count; ++x) ++even[places[x]];
}

}  // namespace

Ranks ranks_of(const std::vector<std::uint64_t>& seen) {
    const auto levels = static_cast<double>(seen.size());
    const auto occur = static_cast<double>(std::count_if(seen.begin(), seen.end(), [](auto count) { return count > 0; }));
    Ranks ranks{std::vector<std::uint16_t>(seen.size()), 0, 0};
    if (occur > levels / 4 && levels > 16) {  // it would cost about as much as it saves
        for (std::size_t i = 0; i < seen.size(); ++i) ranks.of[i] = static_cast<std::uint16_t>(i);
        ranks.levels = static_cast<int>(seen.size());
        return ranks;
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
        ranks.of[i] = static_cast<std::uint16_t>(ranks.levels);
        ranks.levels += seen[i] > 0;
    }
    ranks.bits = (std::lgamma(levels + 1) - std::lgamma(occur + 1) - std::lgamma(levels - occur + 1)) / std::numbers::ln2;
    return ranks;
}

void NeighbourCounts::add(const NeighbourCounts& other) {
    std::transform(near.begin(), near.end(), other.near.begin(), near.begin(), std::plus<>());
    std::transform(errors.begin(), errors.end(), other.errors.begin(), errors.begin(), std::plus<>());
}

NeighbourCounting::NeighbourCounting(const CountedRows& rows, const Ranks& ranks)
    : rows_(rows),
      grid_(rows.whole()),
      ranks_(ranks),
      levels_(static_cast<std::size_t>(ranks.levels)),
      classes_(error_classes(ranks.levels)) {
    const auto all = grid_.slices > 1 ? std::span<const Neighbour>(kSolid) : std::span<const Neighbour>(kFlat);
    std::size_t counters = levels_, used = 0;
    const std::size_t most = most_counters(rows.cells_there());
    for (; used < all.size() && counters * levels_ <= most; ++used) counters *= levels_;
    neighbours_ = all.first(used);
    choose_the_one();
}

// Where one neighbour has room, a sample of the rows tells whether it is that to the left or that above, and whether its exact
// value pays beside prediction; else it is not counted of all.
void NeighbourCounting::choose_the_one() {
    if (neighbours_.size() != 1 || grid_.slices > 1) return;
    const std::size_t rows = rows_.rows(),
                      sampled = std::min(rows, std::max<std::size_t>(1, kSampled / static_cast<std::size_t>(grid_.columns)));
    const std::size_t first = (rows - sampled) / 2;
    const auto cost_of = [&](const NeighbourCounts& counts) { return adaptive_code(counts.near, levels_).learnt; };
    const NeighbourCounts left = count({first, first + sampled});
    double least = cost_of(left);
    neighbours_ = kAbove;
    const double above = cost_of(count({first, first + sampled}));
    if (above < least)
        least = above;
    else
        neighbours_ = std::span(kFlat).first(1);
    if (rows >= 8 * sampled && least > adaptive_code(left.errors, classes_.rest.size()).learnt) neighbours_ = {};
}

void NeighbourCounting::load(std::uint16_t* to, std::size_t row) const {
    const auto columns = static_cast<std::size_t>(grid_.columns);
    const bool same = levels_ == ranks_.of.size();
    grid_.values.visit([&](const auto* values) {
        const auto* from = values + rows_.at(row) * columns;
        if (same) std::copy_n(from, columns, to);
        if (!same) std::transform(from, from + columns, to, [&](auto value) { return ranks_.of[value]; });
    });
}

void NeighbourCounting::load_columns(std::uint8_t* to, std::size_t first, std::size_t count) const {
    const auto columns = static_cast<std::size_t>(grid_.columns), rows = static_cast<std::size_t>(grid_.rows);
    grid_.values.visit([&](const auto* values) {
        for (std::size_t y = 0; y < rows; ++y)
            for (std::size_t x = 0; x < count; ++x)
                to[x * rows + y] = static_cast<std::uint8_t>(ranks_.of[values[y * columns + first + x]]);
    });
}

// Calls take with each row that counts, the two before it and that of the slice before; there are cells of these beside them.
template <typename Take>
void NeighbourCounting::walk(RowRange part, const Take& take) const {
    const auto columns = static_cast<std::size_t>(grid_.columns), slice = static_cast<std::size_t>(grid_.rows);
    std::array<std::vector<std::uint16_t>, 4> rows;
    rows.fill(std::vector<std::uint16_t>(columns + 2 * kPad));
    const auto load_padded = [&](std::vector<std::uint16_t>& to, std::size_t y) {
        load(to.data() + kPad, y);
        std::fill_n(to.begin(), kPad, to[kPad]);
        std::fill_n(to.end() - kPad, kPad, to[columns + kPad - 1]);
    };
    if (part.first > 0) load_padded(rows[1], part.first - 1);
    if (part.first > 1) load_padded(rows[2], part.first - 2);
    for (std::size_t y = part.first; y < part.second; ++y) {
        if (grid_.slices > 1 && y < slice) rows[3] = rows[1];
        if (grid_.slices > 1 && y >= slice) load_padded(rows[3], y - slice);
        load_padded(rows[0], y);
        if (rows_.counts(y)) {
            std::fill_n(rows[0].begin(), kPad, rows[1][kPad]);  // who reads it does not know the row yet
            const std::uint16_t* const at[4] = {rows[0].data() + kPad, rows[1].data() + kPad, rows[2].data() + kPad,
                                                rows[3].data() + kPad};
            take(at);
            std::fill_n(rows[0].begin(), kPad, rows[0][kPad]);
        }
        std::swap(rows[2], rows[1]);
        std::swap(rows[1], rows[0]);
    }
}

// Of each number of neighbours there is a loop of its own, which a compiler unrolls: it is the innermost.
template <std::size_t kUsed, typename Take>
void NeighbourCounting::each_near(const std::uint16_t* const (&rows)[4], std::size_t used, const Take& take) const {
    if constexpr (kUsed > 1)
        if (used < kUsed) return each_near<kUsed - 1>(rows, used, take);
    const std::uint16_t* near[kUsed];
    for (std::size_t i = 0; i < kUsed; ++i) near[i] = rows[neighbours_[i].up] + neighbours_[i].aside;
    const std::size_t levels = levels_;
    for (int x = 0; x < grid_.columns; ++x) {
        std::size_t at = 0;
        for (std::size_t i = kUsed; i-- > 0;) at = at * levels + near[i][x];
        take(at * levels + rows[0][x]);
    }
}

// Where each error of the row is counted.
void NeighbourCounting::find_places(const std::uint16_t* const (&rows)[4], std::uint16_t* places) const {
    const std::uint16_t *const row = rows[0], *const up = rows[1];
    const auto levels = static_cast<int>(levels_);
    const bool voxels = grid_.slices > 1;
    if (!voxels && levels <= 256) return find_small_errors(row, up, grid_.columns, static_cast<Small>(levels), places);
    const std::size_t width = classes_.rest.size();
    for (int x = 0; x < grid_.columns; ++x) {
        const int left = row[x - 1], above = up[x], corner = up[x - 1];
        int predicted = clamped_median(left, above, left + above - corner);
        int rough = std::abs(left - corner) + std::abs(above - corner) + std::abs(above - up[x + 1]);
        if (voxels) {
            predicted = clamped_median(left, above, rows[3][x]);
            rough += std::abs(rows[3][x] - above);
        }
        int error = row[x] - predicted;
        error += error < 0 ? levels : 0;
        const auto roughness = std::min<std::size_t>(kRoughness - 1, std::bit_width(static_cast<unsigned>(rough)));
        places[x] = static_cast<std::uint16_t>(roughness * width + classes_.of[static_cast<std::size_t>(error)]);
    }
}

NeighbourCounts NeighbourCounting::count(RowRange part) const {
    NeighbourCounts counts;
    std::size_t counters = levels_;
    for (std::size_t i = 0; i < neighbours_.size(); ++i) counters *= levels_;
    if (!neighbours_.empty()) counts.near.resize(counters);
    counts.errors.resize(kRoughness * classes_.rest.size());
    std::vector<std::uint32_t> odd(counts.errors.size());
    std::vector<std::uint16_t> places(static_cast<std::size_t>(grid_.columns));
    std::uint32_t* const near = counts.near.data();
    walk(part, [&](const std::uint16_t* const(&rows)[4]) {
        if (neighbours_.size() == 1 && grid_.slices == 1) {
            const std::uint16_t* const beside = rows[neighbours_[0].up] + neighbours_[0].aside;
            for (int x = 0; x < grid_.columns; ++x) ++near[beside[x] * levels_ + rows[0][x]];
        } else if (!neighbours_.empty())
            each_near<std::size(kFlat)>(rows, neighbours_.size(), [near](std::size_t at) { ++near[at]; });
        find_places(rows, places.data());
        count_places(places.data(), places.size(), counts.errors.data(), odd.data());
    });
    std::transform(counts.errors.begin(), counts.errors.end(), odd.begin(), counts.errors.begin(), std::plus<>());
    return counts;
}

NeighbourCounts NeighbourCounting::count_all() const {
    const std::size_t rows = rows_.rows();
    if (rows_.cells_there() < kShared || rows < 2) return count({0, rows});
    NeighbourCounts upper, lower;
    {
        const std::jthread other([&] { upper = count({0, rows / 2}); });
        lower = count({rows / 2, rows});
    }
    lower.add(upper);
    return lower;
}

void NeighbourCounting::tell_near_costs(std::span<const float> costs, std::size_t used, std::span<const RowRange> parts,
                                        const TakeCosts& take) const {
    std::vector<float> found(static_cast<std::size_t>(grid_.columns));
    for (const RowRange& part : parts)
        walk(part, [&](const std::uint16_t* const(&rows)[4]) {
            float* to = found.data();
            each_near<std::size(kFlat)>(rows, used, [&](std::size_t at) { *to++ = costs[at]; });
            take(found);
        });
}

void NeighbourCounting::tell_error_costs(std::span<const float> costs, std::span<const RowRange> parts,
                                         const TakeCosts& take) const {
    std::vector<float> found(static_cast<std::size_t>(grid_.columns));
    std::vector<std::uint16_t> places(found.size());
    for (const RowRange& part : parts)
        walk(part, [&](const std::uint16_t* const(&rows)[4]) {
            find_places(rows, places.data());
            std::transform(places.begin(), places.end(), found.begin(), [&](std::uint16_t place) { return costs[place]; });
            take(found);
        });
}

}  // namespace tactics
