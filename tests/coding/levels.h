// SPDX-License-Identifier: Apache-2.0
// Maps of levels of every kind that a coder can meet: smooth, drawn, noisy, even, hostile to guesses.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "tactics/coding/level_map.h"

namespace tactics::tests {

enum class Ground { even, ramp, hills, noise, steps, letters, spikes, ends };
inline constexpr Ground kGrounds[] = {Ground::even,  Ground::ramp,    Ground::hills,  Ground::noise,
                                      Ground::steps, Ground::letters, Ground::spikes, Ground::ends};

inline Level level_at(Ground ground, int x, int y, int top, std::mt19937& random) {
    const auto share = [top](double part) { return static_cast<Level>(std::lround(part * top)); };
    switch (ground) {
        case Ground::even: return share(0.4);
        case Ground::ramp: return share(((3 * x + 5 * y) % 1000) / 999.0);
        case Ground::hills:
            return share(0.5 + 0.2 * std::sin(x / 17.0) + 0.2 * std::cos(y / 23.0) + 0.05 * std::sin((x + y) / 3.0));
        case Ground::noise: return static_cast<Level>(random() % (static_cast<unsigned>(top) + 1));
        case Ground::steps: return share(((x / 40 + y / 30) % 4) / 3.0);
        case Ground::letters: {  // five shapes of 6 x 8, over and over
            constexpr std::uint64_t kShapes[] = {0x3C6666C3FF81, 0x7E60607C6060, 0x183C7EFF3C18, 0xC3663C183C66, 0xFF8181BDA181};
            const int shape = (x / 9 + 2 * (y / 11)) % 5, column = x % 9, row = y % 11;
            return column < 6 && row < 8 && (kShapes[shape] >> (row * 6 + column) & 1u) != 0 ? share(1) : share(0);
        }
        case Ground::spikes: return random() % 97 == 0 ? share(1) : share(0);
        case Ground::ends:  // each guess is as wrong as it can be
            return (x + y) % 2 == 0 ? share(0) : share(1);
    }
    return 0;
}

inline LevelMap map_of(Ground ground, int columns, int rows, int top) {
    LevelMap map{columns, rows, 0.25, -1.5, 8.25, 9.75 / top, top, "round", {}};
    std::mt19937 random(static_cast<unsigned>(columns * 31 + rows * 7 + top));
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) map.levels.push_back(level_at(ground, x, y, top, random));
    return map;
}

/// A whole decoded file, whose bytes need not live on.
inline LevelMap decoded(const std::string& bytes) { return decode_levels(Container(bytes, "map.felt"), 1'000'000'000); }

}  // namespace tactics::tests
