// SPDX-License-Identifier: Apache-2.0
// How long an adaptive code is, from what was counted.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace tactics {

/// Counters that can learn something from so many cells: four of each, and no more than 2^18.
inline std::size_t most_counters(std::size_t cells) { return std::min<std::size_t>(1 << 18, 4 * cells); }

/// Bits of all that was counted.
struct Code {
    double bits = 0;    ///< it can be written in as many: an upper bound of what is in it
    double learnt = 0;  ///< the same without the cost of learning, so too little by about that
    double free = 0;    ///< how many shares were learnt: kinds that occur in a context, less one
    /// What is in it if values hang on nothing but their contexts: `learnt` with its bias put right (P. Grassberger, "Entropy
    /// estimates from insufficient samplings", 2003), still too little where most contexts were seen but a few times.
    double corrected = 0;
    Code& operator+=(const Code& other);
};

/// Of values of `levels` kinds in any number of contexts, counted context by context. The code that reckons with half a sight of
/// each kind before the first (R. E. Krichevsky, V. K. Trofimov, "The performance of universal encoding", 1981) is, in a context
/// of n values of which c_i are of kind i, as long as log2 of
///     Gamma(n + m/2) / Gamma(m/2) * product of Gamma(1/2) / Gamma(c_i + 1/2),
/// whatever their order, m being `levels`. `learnt` is what their shares tell: the sum of c_i log2(n / c_i).
Code adaptive_code(std::span<const std::uint32_t> counts, std::size_t levels);

/// Of contexts with one value less, the farthest: each of the `fewer` counters is the sum of those that are as many apart.
void add_up(std::vector<std::uint32_t>& counts, std::size_t fewer);

/// What each of them adds to `learnt` every time: log2(n / c_i); 0 for one that was not counted.
std::vector<float> costs_of(std::span<const std::uint32_t> counts, std::size_t levels);

/// Is told such costs of the cells of a row, then of the next: nobody keeps those of a whole grid.
using TakeCosts = std::function<void(std::span<const float>)>;

}  // namespace tactics
