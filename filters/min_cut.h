// SPDX-License-Identifier: Apache-2.0
// The cheapest division of things into two sets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tactics {

/// It costs `weight` if its two ends fall on different sides.
struct CutEdge {
    std::uint32_t a = 0, b = 0;
    std::int64_t weight = 0;
};

/// The side of each thing: true costs its `as_true`, false its `as_false`. Of solutions with equal cost, the one with the fewest
/// true. No cost may be negative. By largest flow (E. A. Dinic, Soviet Math. Doklady 11, 1970).
std::vector<bool> min_cut(std::span<const std::int64_t> as_true, std::span<const std::int64_t> as_false,
                          std::span<const CutEdge> edges);

}  // namespace tactics
