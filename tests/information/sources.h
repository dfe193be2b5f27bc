// SPDX-License-Identifier: Apache-2.0
// Grids of which it is known what is in them, the same on every machine.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tactics/information/grid.h"
#include "tactics/measure/random.h"

namespace tactics::tests {

template <typename Value>
LevelGrid grid_by(int columns, int rows, int levels, const Value& value) {
    std::vector<std::uint16_t> values;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) values.push_back(static_cast<std::uint16_t>(value(x, y)));
    return {columns, rows, 1, levels, std::move(values)};
}

inline LevelGrid noise(int columns, int rows, int levels, std::uint64_t seed) {
    RandomNumbers random(seed);
    return grid_by(columns, rows, levels, [&](int, int) { return random.next() % static_cast<std::uint64_t>(levels); });
}

inline LevelGrid wall(int columns, int rows, int levels) {
    return grid_by(columns, rows, levels, [&](int x, int) { return x < columns / 3 ? 0 : levels - 1; });
}

/// Hills of many sizes, as high as they are wide: a terrain.
inline LevelGrid terrain(int columns, int rows, int levels, std::uint64_t seed) {
    RandomNumbers random(seed);
    struct Wave {
        double x, y, phase, height;
    };
    std::vector<Wave> waves;
    for (int i = 0; i < 40; ++i) {
        const double size = std::exp2(-6 * random.uniform()), turn = 6.2832 * random.uniform();
        waves.push_back(
            {std::cos(turn) * 6.2832 / (200 * size), std::sin(turn) * 6.2832 / (200 * size), 6.2832 * random.uniform(), size});
    }
    std::vector<double> heights;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            double height = 0;
            for (const Wave& wave : waves) height += wave.height * std::sin(wave.x * x + wave.y * y + wave.phase);
            heights.push_back(height);
        }
    const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
    const double low = *least, high = *most;
    return grid_by(columns, rows, levels, [&](int x, int y) {
        const double part = (heights[static_cast<std::size_t>(y * columns + x)] - low) / (high - low);
        return std::min(levels - 1.0, std::floor(part * levels));
    });
}

inline std::vector<std::uint16_t> words_of(const LevelGrid& grid) {
    std::vector<std::uint16_t> words;
    for (std::size_t i = 0; i < grid.count(); ++i) words.push_back(grid.values[i]);
    return words;
}

inline LevelGrid shuffled(const LevelGrid& grid, std::uint64_t seed) {
    RandomNumbers random(seed);
    std::vector<std::uint16_t> words = words_of(grid);
    for (std::size_t i = words.size() - 1; i > 0; --i) std::swap(words[i], words[random.below(i + 1)]);
    return {grid.columns, grid.rows, grid.slices, grid.levels, std::move(words)};
}

/// The same again, so many times, as more rows or as more slices.
inline LevelGrid repeated(const LevelGrid& grid, int times, bool slices) {
    std::vector<std::uint16_t> words;
    const std::vector<std::uint16_t> once = words_of(grid);
    for (int i = 0; i < times; ++i) words.insert(words.end(), once.begin(), once.end());
    return {grid.columns, slices ? grid.rows : times * grid.rows, slices ? times : 1, grid.levels, std::move(words)};
}

}  // namespace tactics::tests
