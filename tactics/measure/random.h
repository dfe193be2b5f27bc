// SPDX-License-Identifier: Apache-2.0
// Chance that is the same on every machine: the standard library's distributions differ between its makers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tactics {

/// splitmix64 (G. L. Steele, D. Lea, C. H. Flood 2014).
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next();
    double uniform();                     ///< [0, 1)
    std::size_t below(std::size_t most);  ///< 0 to most - 1
    std::array<double, 2> normals();      ///< independent, mean 0, standard deviation 1

private:
    std::uint64_t state_ = 0;
};

/// A seed for something counted: unlike for any two counts.
std::uint64_t seed_of(std::uint64_t seed, std::uint64_t count);

}  // namespace tactics
