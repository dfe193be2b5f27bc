// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/pyramid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tactics/information/code_length.h"

namespace tactics {

namespace {

int longest_of(const LevelGrid& grid) { return std::max(grid.columns, grid.rows); }

// Of a side, when the longer of the two becomes `longest`.
int scaled(int side, const LevelGrid& grid, int longest) {
    const long long doubled = 2LL * side * longest / longest_of(grid);
    return std::max(1, static_cast<int>((doubled + 1) / 2));
}

std::vector<int> borders(int before, int after) {
    std::vector<int> at(static_cast<std::size_t>(after) + 1);
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = static_cast<int>(static_cast<long long>(i) * before / after);
    return at;
}

template <bool kMean, typename Value>
LevelGrid pooled(const LevelGrid& grid, const Value* values, int columns, int rows) {
    std::vector<std::uint16_t> out(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    const std::vector<int> across = borders(grid.columns, columns), down = borders(grid.rows, rows);
    std::vector<std::uint64_t> of_row(static_cast<std::size_t>(columns));
    for (int j = 0; j < rows; ++j) {
        const int top = down[static_cast<std::size_t>(j)], bottom = down[static_cast<std::size_t>(j) + 1];
        std::fill(of_row.begin(), of_row.end(), 0);
        for (int y = top; y < bottom; ++y) {
            const Value* from = values + static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns);
            for (std::size_t i = 0; i < of_row.size(); ++i) {
                std::uint32_t sum = 0, most = 0;
                for (int x = across[i]; x < across[i + 1]; ++x) {
                    if constexpr (kMean) sum += from[x];
                    if constexpr (!kMean) most = std::max<std::uint32_t>(most, from[x]);
                }
                of_row[i] = kMean ? of_row[i] + sum : std::max<std::uint64_t>(of_row[i], most);
            }
        }
        std::uint16_t* to = out.data() + static_cast<std::size_t>(j) * of_row.size();
        for (std::size_t i = 0; i < of_row.size(); ++i) {
            const auto cells = static_cast<std::uint64_t>(bottom - top) * static_cast<std::uint64_t>(across[i + 1] - across[i]);
            to[i] = static_cast<std::uint16_t>(kMean ? (of_row[i] + cells / 2) / cells : of_row[i]);
        }
    }
    return {columns, rows, 1, grid.levels, std::move(out)};
}

LevelGrid pooled(const LevelGrid& grid, int columns, int rows, Pooling pooling) {
    return grid.values.visit([&](const auto* values) {
        return pooling == Pooling::mean ? pooled<true>(grid, values, columns, rows) : pooled<false>(grid, values, columns, rows);
    });
}

}  // namespace

LevelGrid resampled(const LevelGrid& grid, int longest, Pooling pooling) {
    if (grid.slices != 1) throw std::logic_error("a map has one slice");
    if (longest >= longest_of(grid)) return grid;
    longest = std::max(1, longest);
    return pooled(grid, scaled(grid.columns, grid, longest), scaled(grid.rows, grid, longest), pooling);
}

LevelGrid enlarged(const LevelGrid& grid, int columns, int rows) {
    std::vector<std::uint16_t> out;
    out.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    const std::vector<int> across = borders(columns, grid.columns), down = borders(rows, grid.rows);
    for (std::size_t j = 0; j + 1 < down.size(); ++j)
        for (int y = down[j]; y < down[j + 1]; ++y)
            for (std::size_t i = 0; i + 1 < across.size(); ++i)
                out.insert(out.end(), static_cast<std::size_t>(across[i + 1] - across[i]),
                           grid.values[j * (across.size() - 1) + i]);
    return {columns, rows, 1, grid.levels, std::move(out)};
}

std::vector<int> sizes_to_try(int longest) {
    std::vector<int> sizes;
    for (int k = 0;; ++k) {
        const int size = static_cast<int>(std::lround(std::exp2(k / 16.0)));
        if (size >= longest) break;
        if (sizes.empty() || size > sizes.back()) sizes.push_back(size);
    }
    sizes.push_back(longest);
    return sizes;
}

std::vector<int> levels_to_try(int levels) {
    std::vector<int> numbers;
    for (int number = 2, step = 1; number < levels; number += step) {
        numbers.push_back(number);
        if (number >= 8 * step) step *= 2;
    }
    numbers.push_back(levels);
    return numbers;
}

Pyramid::Pyramid(LevelGrid grid, Pooling pooling) : pooling_(pooling) {
    check_grid(grid);
    if (grid.slices != 1) throw std::logic_error("a map has one slice");
    halves_.push_back(std::move(grid));
}

const LevelGrid& Pyramid::at(int longest) {
    longest = std::clamp(longest, 1, longest_of(whole()));
    if (longest == longest_of(whole())) return whole();
    if (const auto known = sizes_.find(longest); known != sizes_.end()) return known->second;
    // From the smallest that has two cells for one.
    std::size_t half = 0;
    while (longest_of(halves_[half]) >= 4 * longest) {
        const LevelGrid& larger = halves_[half++];
        if (half == halves_.size())
            halves_.push_back(
                pooled(larger, std::max(1, (larger.columns + 1) / 2), std::max(1, (larger.rows + 1) / 2), pooling_));
    }
    const LevelGrid& from = halves_[half];
    return sizes_
        .emplace(longest,
                 pooled(from, scaled(whole().columns, whole(), longest), scaled(whole().rows, whole(), longest), pooling_))
        .first->second;
}

double Pyramid::bits(int longest, int levels) {
    longest = std::clamp(longest, 1, longest_of(whole()));
    levels = std::clamp(levels, 2, whole().levels);
    const auto [known, fresh] = bits_.try_emplace({longest, levels}, 0.0);
    if (fresh) known->second = code_length(with_levels(at(longest), levels)).best.bits;
    return known->second;
}

// All that is less detailed than something is made of it, and so holds no more: that cuts the search short where all levels are
// there, and caps what an accident of the code would add where they are not.
double Pyramid::most_bits(int longest, int levels) {
    const double all = bits(longest_of(whole()), whole().levels);
    const bool all_levels = levels >= whole().levels;
    if (all_levels && longest >= longest_of(whole())) return all;
    const std::vector<int> sizes = sizes_to_try(longest_of(whole())), numbers = levels_to_try(whole().levels);
    double most = 0;
    for (auto size = sizes.rbegin(); size != sizes.rend() && most < all; ++size)
        for (auto number = numbers.rbegin(); number != numbers.rend() && most < all; ++number) {
            if (*size > longest || *number > levels) continue;
            const double cells = static_cast<double>(scaled(whole().columns, whole(), *size)) *
                                 static_cast<double>(scaled(whole().rows, whole(), *size));
            if (raw_bits(cells, *number) <= most) break;  // with fewer levels even less
            most = std::max(most, bits(*size, *number));
            if (all_levels) break;
        }
    return std::min(all, all_levels ? most : std::min(most, most_bits(longest, whole().levels)));
}

double Pyramid::error(int longest, int levels) {
    levels = std::clamp(levels, 2, whole().levels);
    const LevelGrid there = with_levels(at(longest), levels);
    const LevelGrid back = enlarged(there, whole().columns, whole().rows);
    const double step = static_cast<double>(whole().levels) / levels;
    double square = 0;
    for (std::size_t i = 0; i < back.count(); ++i) {
        const double off = (back.values[i] + 0.5) * step - (whole().values[i] + 0.5);
        square += off * off;
    }
    return std::sqrt(square / static_cast<double>(back.count()));
}

}  // namespace tactics
