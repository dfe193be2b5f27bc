// SPDX-License-Identifier: Apache-2.0
// The cheapest way to part things in two, against trying all ways.
#include "filters/min_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "samples/draw/noise.h"

namespace tactics::min_cut_test {
namespace {

struct Problem {
    std::vector<std::int64_t> as_true, as_false;
    std::vector<CutEdge> edges;
};

std::int64_t cost_of(const Problem& problem, const std::vector<bool>& side) {
    std::int64_t cost = 0;
    for (std::size_t i = 0; i < side.size(); ++i) cost += side[i] ? problem.as_true[i] : problem.as_false[i];
    for (const CutEdge& edge : problem.edges) cost += side[edge.a] != side[edge.b] ? edge.weight : 0;
    return cost;
}

struct Cheapest {
    std::int64_t cost = std::numeric_limits<std::int64_t>::max();
    std::ptrdiff_t fewest = 0;
};

Cheapest try_all(const Problem& problem) {
    Cheapest best;
    for (unsigned ways = 0; ways < 1u << problem.as_true.size(); ++ways) {
        std::vector<bool> side;
        for (std::size_t i = 0; i < problem.as_true.size(); ++i) side.push_back((ways >> i & 1) != 0);
        const std::int64_t cost = cost_of(problem, side);
        const std::ptrdiff_t chosen = std::count(side.begin(), side.end(), true);
        if (cost < best.cost || (cost == best.cost && chosen < best.fewest)) best = {cost, chosen};
    }
    return best;
}

TEST(MinCut, IsAsCheapAsTheBestOfAllWays) {
    for (int trial = 0; trial < 200; ++trial) {
        int k = 0;
        const auto number = [&](int below) {
            return static_cast<std::int64_t>(static_cast<float>(below) * samples::chance(trial, ++k, 7));
        };
        Problem problem;
        const auto count = static_cast<std::uint32_t>(1 + number(10));
        for (std::uint32_t i = 0; i < count; ++i) {
            problem.as_true.push_back(number(9));
            problem.as_false.push_back(number(9));
        }
        for (std::int64_t e = number(25); e > 0; --e)
            problem.edges.push_back({static_cast<std::uint32_t>(number(static_cast<int>(count))),
                                     static_cast<std::uint32_t>(number(static_cast<int>(count))), number(8)});
        const auto side = min_cut(problem.as_true, problem.as_false, problem.edges);
        const Cheapest best = try_all(problem);
        ASSERT_EQ(cost_of(problem, side), best.cost) << "trial " << trial;
        ASSERT_EQ(std::count(side.begin(), side.end(), true), best.fewest) << "trial " << trial;
    }
}

TEST(MinCut, ALongChainBreaksAtItsWeakestLink) {
    constexpr std::uint32_t kCount = 5000;
    Problem problem{std::vector<std::int64_t>(kCount, 0), std::vector<std::int64_t>(kCount, 0), {}};
    problem.as_false.front() = problem.as_true.back() = 100;
    for (std::uint32_t i = 0; i + 1 < kCount; ++i) problem.edges.push_back({i, i + 1, i == 3000 ? 2 : 3});
    const auto side = min_cut(problem.as_true, problem.as_false, problem.edges);
    EXPECT_EQ(std::count(side.begin(), side.end(), true), 3001);
}

TEST(MinCut, NothingAtAll) { EXPECT_TRUE(min_cut({}, {}, {}).empty()); }

}  // namespace
}  // namespace tactics::min_cut_test
