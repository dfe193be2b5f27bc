// SPDX-License-Identifier: Apache-2.0
// How long an adaptive code is, from what was counted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace tactics {

/// Bits of all that was counted.
struct Code {
    double bits = 0;    ///< it can be written in as many: an upper bound of what is in it
    double learnt = 0;  ///< the same without the cost of learning, so too little by about that
};

/// Of values of `levels` kinds in any number of contexts, counted context by context. The code that reckons with half a sight of
/// each kind before the first (R. E. Krichevsky, V. K. Trofimov, "The performance of universal encoding", 1981) is, in a context
/// of n values of which c_i are of kind i, as long as log2 of
///     Gamma(n + m/2) / Gamma(m/2) * product of Gamma(1/2) / Gamma(c_i + 1/2),
/// whatever their order, m being `levels`. `learnt` is what their shares tell: the sum of c_i log2(n / c_i).
Code adaptive_code(std::span<const std::uint32_t> counts, std::size_t levels);

}  // namespace tactics
