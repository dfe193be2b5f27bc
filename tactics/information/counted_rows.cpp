// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/counted_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace tactics {

namespace {

constexpr std::size_t kCounted = 1'500'000;
constexpr std::size_t kLeastBands = 32;
constexpr double kUnlike = 0.05;
constexpr std::size_t kWeighed = 1 << 19, kParts = 64, kPart = 4096;

// Of each row, how much its cells differ from those to their left.
template <typename Value>
std::vector<double> differences(const Value* values, std::size_t rows, std::size_t columns) {
    std::vector<double> all;
    all.reserve(rows);
    for (std::size_t y = 0; y < rows; ++y) {
        const Value* row = values + y * columns;
        std::uint32_t sum = 0;  // of 65,536 columns at most 2^32
        double whole = 0;
        for (std::size_t from = 1; from < columns; from += 65'536) {
            sum = 0;
            const std::size_t end = std::min(columns, from + 65'536);
            for (std::size_t x = from; x < end; ++x) sum += static_cast<std::uint32_t>(std::abs(row[x] - row[x - 1]));
            whole += sum;
        }
        all.push_back(whole);
    }
    return all;
}

// A xorshift of G. Marsaglia (2003): no two bands are as far apart as the next.
std::size_t random_below(std::uint64_t& state, std::size_t most) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return static_cast<std::size_t>(state % most);
}

}  // namespace

CountedRows::CountedRows(const LevelGrid& whole) : whole_(whole) {
    const auto columns = static_cast<std::size_t>(whole.columns), rows = static_cast<std::size_t>(whole.rows);
    const std::size_t bands = kCounted / ((kBand - kBefore) * columns);
    if (whole.slices != 1 || bands < kLeastBands || rows < 2 * bands * kBand) return;
    const std::vector<double> differ = whole.values.visit([&](const auto* values) { return differences(values, rows, columns); });
    std::vector<std::size_t> firsts;
    std::uint64_t state = 0x9e3779b97f4a7c15;
    double counted = 0, all = 0;
    for (const double one : differ) all += one;
    for (std::size_t i = 0; i < bands; ++i) {
        const std::size_t from = i * rows / bands, to = (i + 1) * rows / bands;
        firsts.push_back(from + random_below(state, to - from - kBand + 1));
        for (std::size_t y = kBefore; y < kBand; ++y) counted += differ[firsts.back() + y];
    }
    const double share = static_cast<double>(bands * (kBand - kBefore)) / static_cast<double>(rows);
    unlike_ = all > 0 ? std::abs(counted / share / all - 1) : 0;
    if (unlike_ > kUnlike) {
        unlike_ = 0;
        return;
    }
    const auto take = [&](const auto* values) {
        using Value = std::remove_cvref_t<decltype(*values)>;
        std::vector<Value> taken;
        taken.reserve(bands * kBand * columns);
        for (const std::size_t first : firsts)
            taken.insert(taken.end(), values + first * columns, values + (first + kBand) * columns);
        return Cells(std::move(taken));
    };
    bands_ = {whole.columns, static_cast<int>(bands * kBand), 1, whole.levels, whole.values.visit(take)};
}

double CountedRows::cells() const { return share() * static_cast<double>(whole_.count()); }

double CountedRows::share() const {
    return bands_.count() == 0 ? 1 : static_cast<double>(bands_.rows) * (kBand - kBefore) / kBand / whole_.rows;
}

std::vector<RowRange> CountedRows::parts() const {
    const LevelGrid& of = grid();
    const auto columns = static_cast<std::size_t>(of.columns);
    const std::size_t rows = of.count() / columns, size = std::max<std::size_t>(1, kPart / columns);
    std::vector<RowRange> found;
    if (bands_.count() > 0) {
        for (std::size_t y = kBefore; y < rows; y += kBand) found.emplace_back(y, y + std::min(size, kBand - kBefore));
        return found;
    }
    if (of.count() <= kWeighed || rows < kParts * size) return {{0, rows}};
    for (std::size_t i = 0; i < kParts; ++i)
        found.emplace_back(i * (rows - size) / (kParts - 1), i * (rows - size) / (kParts - 1) + size);
    return found;
}

}  // namespace tactics
