// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/repeats.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <type_traits>

#include "tactics/information/random_below.h"

namespace tactics {

namespace {

LevelGrid cut_out(const LevelGrid& grid, int left, int top, int columns, int rows) {
    return grid.values.visit([&](const auto* values) -> LevelGrid {
        std::vector<std::uint16_t> part;
        part.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
        for (int y = top; y < top + rows; ++y) {
            const auto* row = values + static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns) + left;
            part.insert(part.end(), row, row + columns);
        }
        return {columns, rows, 1, grid.levels, std::move(part)};
    });
}

using Places = std::vector<std::size_t>;  // in order, the first of them 0

// Rows that differ from the one before.
template <typename Value>
Places fresh_rows(const Value* values, std::size_t columns, std::size_t rows) {
    Places fresh = {0};
    for (std::size_t y = 1; y < rows; ++y)
        if (!std::equal(values + y * columns, values + (y + 1) * columns, values + (y - 1) * columns)) fresh.push_back(y);
    return fresh;
}

// Whether all rows that equal the one before are of one value: any code writes such rows for next to nothing.
template <typename Value>
bool only_plain_rows_repeat(const Value* values, std::size_t columns, std::size_t rows) {
    for (std::size_t y = 1; y < rows; ++y) {
        const Value* row = values + y * columns;
        if (std::equal(row, row + columns, row - columns) && !std::equal(row + 1, row + columns, row)) return false;
    }
    return true;
}

// Columns that differ from the one before in one of these rows; nothing if there are more than `most`.
template <typename Value>
std::optional<Places> fresh_columns(const Value* values, std::size_t columns, const Places& rows, std::size_t most) {
    std::vector<std::uint8_t> differs(columns);
    const auto too_many = [&] { return 1 + static_cast<std::size_t>(std::count(differs.begin(), differs.end(), 1)) > most; };
    constexpr std::size_t kLooks = 16;  // rows, between one count and the next
    // From all over the grid, each once: most grids with plain skies are known from few rows.
    std::size_t step = 1 + 618 * rows.size() / 1000;
    while (std::gcd(step, rows.size()) > 1) ++step;
    for (std::size_t i = 0, at = 0; i < rows.size(); ++i, at = (at + step) % rows.size()) {
        const Value* row = values + rows[at] * columns;
        for (std::size_t x = 1; x < columns; ++x) differs[x] = static_cast<std::uint8_t>(differs[x] | (row[x] != row[x - 1]));
        if (i % kLooks == 0 && too_many()) return {};
    }
    if (too_many()) return {};
    Places fresh = {0};
    for (std::size_t x = 1; x < columns; ++x)
        if (differs[x] != 0) fresh.push_back(x);
    return fresh;
}

// Bits that say which of so many they are: as they come, or, where all distances but the first are one, that one and where they
// begin.
double bits_of_places(const Places& places, std::size_t of) {
    const auto all = static_cast<double>(of), some = static_cast<double>(places.size());
    bool even = true;
    for (std::size_t i = 3; i < places.size(); ++i) even = even && places[i] - places[i - 1] == places[2] - places[1];
    const double any = (std::lgamma(all) - std::lgamma(some) - std::lgamma(all - some + 1)) / std::numbers::ln2;
    return std::min(even ? 2 * std::log2(all) : any, any) + 1;
}

// Cells that differ from the one beside or above them, here and there: where nothing changes nothing can be seen.
struct TellingCell {
    int x = 0, y = 0;
};
std::vector<TellingCell> telling_cells(const LevelGrid& grid) {
    constexpr std::size_t kTelling = 32, kTries = 4096;
    const auto columns = static_cast<std::size_t>(grid.columns);
    std::vector<TellingCell> cells;
    std::uint64_t state = 0x2545f4914f6cdd1d;
    for (std::size_t i = 0; i < kTries && cells.size() < kTelling; ++i) {
        const std::size_t cell = random_below(state, grid.count());
        if ((cell % columns > 0 && grid.values[cell] != grid.values[cell - 1]) ||
            (cell >= columns && grid.values[cell] != grid.values[cell - columns]))
            cells.push_back({static_cast<int>(cell % columns), static_cast<int>(cell / columns)});
    }
    return cells;
}

template <typename Value>
bool agrees(const Value* values, const LevelGrid& grid, const Shift& shift, const TellingCell& cell) {
    const int x = cell.x - shift.aside, y = cell.y - shift.down;
    if (x < 0 || x >= grid.columns || y < 0) return true;
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(cell.y) * grid.columns + cell.x;
    return values[at] == values[at - static_cast<std::ptrdiff_t>(shift.down) * grid.columns - shift.aside];
}

// Rows from the first that has one above on in which it holds, up to the first in which it does not.
template <typename Value>
int rows_that_hold(const Value* values, const LevelGrid& grid, const Shift& shift) {
    const std::ptrdiff_t columns = grid.columns, left = std::max(0, shift.aside), right = grid.columns + std::min(0, shift.aside);
    for (int y = shift.down; y < grid.rows; ++y) {
        const Value* row = values + y * columns;
        if (!std::equal(row + left, row + right, values + (y - shift.down) * columns + left - shift.aside)) return y - shift.down;
    }
    return grid.rows - shift.down;
}

long long cells_left(const LevelGrid& grid, const Shift& shift) {
    return static_cast<long long>(shift.down) * grid.columns +
           static_cast<long long>(std::abs(shift.aside)) * (grid.rows - shift.down);
}

// Shifts that hold at those cells, the one that leaves the fewest cells first.
template <typename Value>
std::vector<Shift> likely_shifts(const Value* values, const LevelGrid& grid, const std::vector<TellingCell>& telling) {
    const int widest = std::min(kMostShift, grid.columns / 2), deepest = std::min(kMostShift, grid.rows / 2);
    std::vector<Shift> likely;
    for (int down = 0; down <= deepest; ++down)
        for (int aside = down > 0 ? -widest : 1; aside <= widest; ++aside)
            if (std::all_of(telling.begin(), telling.end(), [&](const TellingCell& cell) {
                    return agrees(values, grid, {aside, down}, cell);
                }))
                likely.push_back({aside, down});
    std::stable_sort(likely.begin(), likely.end(),
                     [&](const Shift& a, const Shift& b) { return cells_left(grid, a) < cells_left(grid, b); });
    return likely;
}

}  // namespace

std::optional<Reduced> reduced(const LevelGrid& grid) {
    const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows);
    if (grid.slices != 1) return {};
    return grid.values.visit([&](const auto* values) -> std::optional<Reduced> {
        const Places down = fresh_rows(values, columns, rows);
        if (down.size() < rows && only_plain_rows_repeat(values, columns, rows) &&
            !fresh_columns(values, columns, down, columns - 1))
            return {};
        const std::size_t most = 97 * grid.count() / (100 * down.size());
        const std::optional<Places> across = fresh_columns(values, columns, down, most);
        if (!across) return {};
        std::vector<std::remove_cvref_t<decltype(*values)>> left;
        left.reserve(across->size() * down.size());
        for (const std::size_t y : down) {
            const auto* row = values + y * columns;
            if (across->size() == columns)
                left.insert(left.end(), row, row + columns);
            else
                for (const std::size_t x : *across) left.push_back(row[x]);
        }
        return Reduced{{static_cast<int>(across->size()), static_cast<int>(down.size()), 1, grid.levels, std::move(left)},
                       bits_of_places(*across, columns) + bits_of_places(down, rows)};
    });
}

std::optional<Shift> shift_of(const LevelGrid& grid) {
    constexpr int kReadings = 8;  // of all rows: most of what does not hold ends at the first
    if (grid.slices != 1) return {};
    const std::vector<TellingCell> telling = telling_cells(grid);
    if (telling.empty()) return {};
    return grid.values.visit([&](const auto* values) -> std::optional<Shift> {
        int left = kReadings * grid.rows;
        for (const Shift& shift : likely_shifts(values, grid, telling)) {
            const int rows = rows_that_hold(values, grid, shift);
            if (rows == grid.rows - shift.down) return shift;
            left -= rows + 1;
            if (left < 0) break;
        }
        return {};
    });
}

std::vector<LevelGrid> borders_of(const LevelGrid& grid, const Shift& shift) {
    std::vector<LevelGrid> borders;
    if (shift.down > 0) borders.push_back(cut_out(grid, 0, 0, grid.columns, shift.down));
    const int aside = std::abs(shift.aside);
    if (aside > 0)
        borders.push_back(cut_out(grid, shift.aside > 0 ? 0 : grid.columns - aside, shift.down, aside, grid.rows - shift.down));
    return borders;
}

}  // namespace tactics
