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

// Of each row, the sum of the differences between its cells and those `back` cells before them: 1 is the cell to the left,
// `columns` the cell above.
template <typename Value>
std::vector<double> differences(const Value* values, std::size_t rows, std::size_t columns, std::size_t back) {
    std::vector<double> all(back == columns ? 1 : 0);
    all.reserve(rows);
    for (std::size_t y = all.size(); y < rows; ++y) {
        const Value* row = values + y * columns;
        const Value* before = row - back;
        std::uint32_t sum = 0;  // of 65,536 columns at most 2^32
        double whole = 0;
        for (std::size_t from = back == 1 ? 1 : 0; from < columns; from += 65'536) {
            sum = 0;
            const std::size_t end = std::min(columns, from + 65'536);
            for (std::size_t x = from; x < end; ++x) sum += static_cast<std::uint32_t>(std::abs(row[x] - before[x]));
            whole += sum;
        }
        all.push_back(whole);
    }
    return all;
}

// A xorshift of G. Marsaglia (2003). Bands at even distances would miss what repeats at that distance.
std::size_t random_below(std::uint64_t& state, std::size_t most) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return static_cast<std::size_t>(state % most);
}

// By which share of the whole the bands have more or less of these differences than their share of the rows.
double unlikeness(const std::vector<double>& differ, const std::vector<std::size_t>& firsts) {
    double counted = 0, all = 0;
    for (const double one : differ) all += one;
    for (const std::size_t first : firsts)
        for (std::size_t y = CountedRows::kBefore; y < CountedRows::kBand; ++y) counted += differ[first + y];
    const double rows = static_cast<double>(firsts.size() * (CountedRows::kBand - CountedRows::kBefore));
    return all > 0 ? std::abs(counted / rows * static_cast<double>(differ.size()) / all - 1) : 0;
}

std::size_t period_of(const LevelGrid& grid) {
    const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows);
    if (grid.slices != 1) return 0;
    return grid.values.visit([&](const auto* values) -> std::size_t {
        const auto is_same = [&](std::size_t y, std::size_t period) {
            return std::equal(values + y * columns, values + (y + 1) * columns, values + (y - period) * columns);
        };
        for (std::size_t period = 1; period <= std::min(CountedRows::kMostPeriod, rows / 2); ++period) {
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

}  // namespace

CountedRows::CountedRows(const LevelGrid& whole) : whole_(whole), period_(period_of(whole)) {
    const auto columns = static_cast<std::size_t>(whole.columns), rows = static_cast<std::size_t>(whole.rows);
    const std::size_t bands = std::max(kLeastBands, kCounted / ((kBand - kBefore) * columns));
    if (whole.slices != 1 || rows < 2 * bands * kBand || period_ > 0) return;
    std::vector<std::size_t> firsts;
    std::uint64_t state = 0x9e3779b97f4a7c15;
    for (std::size_t i = 0; i < bands; ++i) {
        const std::size_t from = i * rows / bands, to = (i + 1) * rows / bands;
        firsts.push_back(from + random_below(state, to - from - kBand + 1));
    }
    for (const std::size_t back : {std::size_t{1}, columns})
        unlike_ = std::max(unlike_, whole.values.visit([&](const auto* values) {
            return unlikeness(differences(values, rows, columns, back), firsts);
        }));
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
    const auto columns = static_cast<std::size_t>(grid().columns);
    const std::size_t rows = grid().count() / columns;
    if (bands_.count() == 0) return parts_of(rows, columns);
    std::vector<RowRange> found;
    const std::size_t size = std::clamp<std::size_t>(kPart / columns, 1, kBand - kBefore);
    for (std::size_t y = kBefore; y < rows; y += kBand) found.emplace_back(y, y + size);
    return found;
}

std::vector<RowRange> parts_of(std::size_t rows, std::size_t columns) {
    const std::size_t size = std::max<std::size_t>(1, kPart / columns);
    std::vector<RowRange> found;
    if (rows * columns <= kWeighed || rows < kParts * size) return {{0, rows}};
    for (std::size_t i = 0; i < kParts; ++i)
        found.emplace_back(i * (rows - size) / (kParts - 1), i * (rows - size) / (kParts - 1) + size);
    return found;
}

}  // namespace tactics
