// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/random.h"

#include <algorithm>
#include <cmath>

namespace tactics {

std::uint64_t RandomNumbers::next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double RandomNumbers::uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

std::size_t RandomNumbers::below(std::size_t most) {
    return std::min(most - 1, static_cast<std::size_t>(uniform() * static_cast<double>(most)));
}

// The polar method (G. Marsaglia, T. A. Bray 1964).
std::array<double, 2> RandomNumbers::normals() {
    for (;;) {
        const double x = 2 * uniform() - 1, y = 2 * uniform() - 1;
        const double square = x * x + y * y;
        if (square <= 0 || square >= 1) continue;
        const double scale = std::sqrt(-2 * std::log(square) / square);
        return {x * scale, y * scale};
    }
}

std::uint64_t seed_of(std::uint64_t seed, std::uint64_t count) {
    return RandomNumbers(RandomNumbers(seed).next() + count).next();
}

}  // namespace tactics
