// SPDX-License-Identifier: Apache-2.0
// Places to look at, the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tactics {

/// The next of a series of numbers, 0 to most - 1 (xorshift64, G. Marsaglia, 2003). `state`: any but 0 to begin with; most > 0.
inline std::size_t random_below(std::uint64_t& state, std::size_t most) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return static_cast<std::size_t>(state % most);
}

}  // namespace tactics
