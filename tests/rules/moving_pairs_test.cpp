// SPDX-License-Identifier: Apache-2.0
// What is too close while lines move, beside looking at the moved page anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "tactics/rules/narrow.h"
#include "tests/rules/pages.h"

namespace tactics::moving_pairs_test {
namespace {

using namespace tests;

constexpr double kLimit = 4;
constexpr std::size_t kAll = 1'000'000;

std::vector<Segment> lines_of(const PageGeometry& geometry) {
    std::vector<Segment> lines;
    for (const Piece& piece : geometry.pieces) lines.push_back(piece.line);
    return lines;
}

// Which pieces, and how far apart to a thousandth.
std::set<std::tuple<std::uint32_t, std::uint32_t, long>> told(const NarrowPairs& found) {
    std::set<std::tuple<std::uint32_t, std::uint32_t, long>> all;
    for (const NarrowPair& pair : found.pairs)
        all.insert({std::min(pair.one, pair.other), std::max(pair.one, pair.other), std::lround(1000 * pair.measured)});
    return all;
}

Page tangle(unsigned seed) {
    Dice chance(seed);
    Page page = blank_page(120, 120);
    for (int i = 0; i < 14; ++i)
        add_line(page, wandering_line(chance, {chance.between(20, 100), chance.between(20, 100)}, 6, 12), 0.8, i % 4 == 0);
    return page;
}

TEST(MovingPairs, AreThoseOfThePageWhereNothingMoves) {
    std::size_t found = 0;
    for (unsigned seed = 1; seed <= 10; ++seed)
        for (const Apart apart : {Apart::edges, Apart::middles}) {
            const Page page = tangle(seed);
            const PageGeometry geometry(page);
            const NarrowPairs plain = narrow_pairs(geometry, kLimit, apart);
            const NarrowPairs moving = MovingNarrowPairs(geometry, kLimit, apart, 1).pairs(lines_of(geometry), kAll);
            EXPECT_EQ(told(moving), told(plain)) << seed;
            EXPECT_TRUE(moving.complete);
            found += plain.pairs.size();
        }
    EXPECT_GT(found, 1000u);
}

// Lines that do not meet, so that no bend can become a gap: a new examination of the moved page gives the same pairs.
TEST(MovingPairs, AreThoseOfTheMovedPage) {
    std::size_t found = 0, fresh = 0;
    for (unsigned seed = 1; seed <= 10; ++seed) {
        Dice chance(seed);
        const auto drawn = [&](const std::vector<double>& by) {
            Page page = blank_page(120, 120);
            for (std::size_t i = 0; i < by.size(); ++i) {
                const double y = 10 + 5.2 * static_cast<double>(i) + by[i];
                add_line(page, {{20, y}, {100, y}}, 0.8);
            }
            return page;
        };
        const Page page = drawn(std::vector<double>(18, 0.0));
        const PageGeometry geometry(page);
        MovingNarrowPairs moving(geometry, kLimit, Apart::edges, 1);
        const std::size_t before = moving.pairs(lines_of(geometry), kAll).pairs.size();
        for (int round = 0; round < 3; ++round) {
            std::vector<double> by;
            for (int i = 0; i < 18; ++i) by.push_back(chance.between(-1, 1));
            const Page moved = drawn(by);
            const PageGeometry anew(moved);
            const NarrowPairs plain = narrow_pairs(anew, kLimit, Apart::edges);
            EXPECT_EQ(told(moving.pairs(lines_of(anew), kAll)), told(plain)) << seed << " " << round;
            found += plain.pairs.size();
            fresh += plain.pairs.size() > before;
        }
    }
    EXPECT_GT(found, 1000u);
    EXPECT_GT(fresh, 0u);
}

TEST(MovingPairs, EndWhereThereAreMoreThanAreAskedFor) {
    const Page page = tangle(3);
    const PageGeometry geometry(page);
    MovingNarrowPairs moving(geometry, kLimit, Apart::edges, 1);
    const std::size_t all = moving.pairs(lines_of(geometry), kAll).pairs.size();
    ASSERT_GT(all, 20u);
    EXPECT_EQ(moving.pairs(lines_of(geometry), 10).pairs.size(), 11u);
    EXPECT_EQ(moving.pairs(lines_of(geometry), kAll).pairs.size(), all);
}

}  // namespace
}  // namespace tactics::moving_pairs_test
