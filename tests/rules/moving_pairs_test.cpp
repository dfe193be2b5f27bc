// SPDX-License-Identifier: Apache-2.0
// What is too close while lines move, beside looking at the moved page anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

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

// Looks at the page as it is.
NarrowPairs narrow_pairs(const PageGeometry& geometry, double limit, Apart apart) {
    NarrowSuspects suspects(geometry, limit, apart);
    NarrowPairs found;
    for (std::size_t i = 0; i < suspects.all().size(); ++i)
        if (const auto [one, other, measured] = suspects.all()[i]; suspects.is_narrow(i))
            found.pairs.push_back({one, other, measured, {}, {}});
    found.complete = suspects.complete();
    return found;
}

Page tangle(unsigned seed) {
    Dice chance(seed);
    Page page = blank_page(120, 120);
    for (int i = 0; i < 14; ++i)
        add_line(page, wandering_line(chance, {chance.between(20, 100), chance.between(20, 100)}, 6, 12), 0.8, i % 4 == 0);
    return page;
}

// The rule tells the narrowest of them; they are asked about in any order, and twice.
TEST(NarrowSuspects, AnswerAsTheRuleDoesInAnyOrder) {
    std::size_t places = 0, no = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const Page page = tangle(seed);
        const PageGeometry geometry(page);
        NarrowSuspects suspects(geometry, kLimit, Apart::edges);
        ASSERT_TRUE(suspects.complete());
        std::vector<std::size_t> order(suspects.all().size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        Dice chance(seed);
        for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[chance.below(i)]);
        std::map<std::pair<std::uint32_t, std::uint32_t>, double> narrowest;
        std::vector<bool> answers(order.size());
        for (const std::size_t i : order) {
            const auto [one, other, measured] = suspects.all()[i];
            answers[i] = suspects.is_narrow(i);
            no += !answers[i];
            if (!answers[i]) continue;
            const std::uint32_t a = geometry.pieces[one].chain, b = geometry.pieces[other].chain;
            const auto [known, fresh] = narrowest.try_emplace({std::min(a, b), std::max(a, b)}, measured);
            if (!fresh) known->second = std::min(known->second, measured);
        }
        for (const std::size_t i : order) EXPECT_EQ(suspects.is_narrow(i), answers[i]);
        std::multiset<double> expected, found;
        for (const Finding& finding : narrow_places(geometry, kLimit, Apart::edges).places) expected.insert(finding.measured);
        for (const auto& [chains, measured] : narrowest) found.insert(measured);
        EXPECT_EQ(found, expected) << seed;
        places += expected.size();
    }
    EXPECT_GT(places, 100u);
    EXPECT_GT(no, 1000u);
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
