// SPDX-License-Identifier: Apache-2.0
// Groups of things, built from pairs (union-find).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace tactics {

/// Each group is named by the number of its first thing. Takes almost constant time per pair (R. E. Tarjan's union-find, with
/// path halving).
class Lots {
public:
    explicit Lots(std::size_t count) : of_(count) { std::iota(of_.begin(), of_.end(), 0u); }
    std::uint32_t find(std::uint32_t one) {
        while (of_[one] != one) one = of_[one] = of_[of_[one]];
        return one;
    }
    /// False: they were in the same group already.
    bool join(std::uint32_t one, std::uint32_t other) {
        one = find(one), other = find(other);
        if (one != other) of_[std::max(one, other)] = std::min(one, other);
        return one != other;
    }

    /// The things of each group, groups and things in their order.
    std::vector<std::vector<std::size_t>> groups() {
        std::vector<std::vector<std::size_t>> all(of_.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[find(static_cast<std::uint32_t>(i))].push_back(i);
        std::erase_if(all, [](const std::vector<std::size_t>& one) { return one.empty(); });
        return all;
    }

private:
    std::vector<std::uint32_t> of_;
};

}  // namespace tactics
