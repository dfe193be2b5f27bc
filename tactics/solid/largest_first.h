// SPDX-License-Identifier: Apache-2.0
// An order by size that the last digits of sizes do not decide.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace tactics {

/// The places of `sizes`, the largest first. Sizes that differ from the next one by no more than the share `same` count as one
/// size, and keep the order that they were given in.
inline std::vector<std::size_t> largest_first(const std::vector<double>& sizes, double same) {
    std::vector<std::size_t> order(sizes.size()), rank(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
    for (std::size_t i = 1; i < order.size(); ++i)
        rank[order[i]] = rank[order[i - 1]] + (sizes[order[i - 1]] > sizes[order[i]] * (1 + same) ? 1 : 0);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank[a] < rank[b]; });
    return order;
}

}  // namespace tactics
