// SPDX-License-Identifier: Apache-2.0
// An order by size that the last digits of sizes do not decide.
#pragma once

#include <algorithm>
#include <cmath>
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

/// Numbers that differ from the next one by no more than the share `same`, or by `least_apart`, become one number, so that
/// nothing else tells them apart.
inline void make_alike(std::vector<double>& numbers, double same, double least_apart = 0) {
    constexpr double kWidest = 10;  // times that: a row of numbers so close to each other is no single one
    std::vector<std::size_t> order(numbers.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return numbers[a] < numbers[b]; });
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        const double least = numbers[order[begin]], margin = std::max(same * std::abs(least), least_apart);
        double most = least;
        for (end = begin + 1; end < order.size(); ++end) {
            const double next = numbers[order[end]];
            if (next > most + margin || next > least + kWidest * margin) break;
            most = next;
        }
        for (std::size_t i = begin; i < end; ++i) numbers[order[i]] = least + (most - least) / 2;
    }
}

}  // namespace tactics
