// SPDX-License-Identifier: Apache-2.0
// Height maps to be felt: what a finger finds hard.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tactics/measure/random.h"
#include "tactics/relief/heightmap.h"

namespace tactics {

/// Heights by a function of the place in mm.
template <typename Height>
HeightMap map_of(int columns, int rows, double pitch, Height height) {
    HeightMap map{columns, rows, pitch, std::vector<float>(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows))};
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            map.at(column, row) = static_cast<float>(height((column + 0.5) * pitch, (row + 0.5) * pitch));
    return map;
}

/// Hills and a texture of 0.4 mm on them.
inline double terrain(double x, double y) {
    return 6 + 3 * std::sin(x / 9) * std::cos(y / 7) + 1.5 * std::sin((x + 2 * y) / 5) +
           0.2 * std::sin(x * 2.1) * std::sin(y * 1.7);
}

struct HardRelief {
    std::string name;
    HeightMap map;
};

inline std::vector<HardRelief> hard_reliefs() {
    constexpr float kHole = std::numeric_limits<float>::quiet_NaN();
    RandomNumbers random(5);
    std::vector<HardRelief> made;
    made.push_back({"terrain", map_of(160, 120, 0.25, terrain)});
    made.push_back({"wall", map_of(80, 60, 0.5, [](double x, double) { return x < 20 ? 0 : 20; })});
    made.push_back({"pit", map_of(60, 60, 0.5, [](double x, double y) { return std::hypot(x - 15, y - 15) < 6 ? 0 : 10; })});
    made.push_back(
        {"steps", map_of(60, 60, 0.5, [](double x, double y) { return 2 * std::floor(x / 4) + 3 * std::floor(y / 7); })});
    made.push_back({"noise", map_of(50, 50, 0.3, [&](double, double) { return 4 * random.uniform(); })});
    made.push_back({"dots", map_of(40, 40, 0.5,
                                   [](double x, double y) { return std::fmod(x, 9) < 0.5 && std::fmod(y, 9) < 0.5 ? 0.6 : 0; })});
    HeightMap spikes = map_of(40, 40, 0.5, [](double, double) { return 1; }), holes = map_of(40, 40, 0.5, terrain);
    for (int i = 0; i < 60; ++i) {
        spikes.at(static_cast<int>(random.below(40)), static_cast<int>(random.below(40))) = i % 2 == 0 ? 15 : -15;
        holes.at(static_cast<int>(random.below(40)), static_cast<int>(random.below(40))) =
            i % 3 == 0 ? std::numeric_limits<float>::infinity() : kHole;
    }
    made.push_back({"spikes", spikes});
    made.push_back({"holes", holes});
    made.push_back({"only holes", map_of(3, 4, 1, [&](double, double) { return kHole; })});
    made.push_back({"one sample", map_of(1, 1, 2, [](double, double) { return 3; })});
    made.push_back({"one row", map_of(30, 1, 0.5, terrain)});
    made.push_back({"one column", map_of(1, 30, 0.5, terrain)});
    return made;
}

}  // namespace tactics
