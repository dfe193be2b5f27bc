// SPDX-License-Identifier: Apache-2.0
// The shortest way through ink, beside the same by going from every contact to every other.
#include "tactics/rules/ink_way.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/rules/pages.h"

namespace tactics::ink_way_test {
namespace {

using namespace tests;

// E. W. Dijkstra, 1959, without a heap and without giving up.
double naive_way(const PageGeometry& geometry, const Station& from, const Station& to) {
    struct Side {
        Station leaves, comes;
        double apart, way;
        bool done;
    };
    const double never = std::numeric_limits<double>::infinity();
    const auto along = [&](const Station& a, const Station& b) {
        return a.chain == b.chain ? PageGeometry::way(geometry.chains[a.chain], a.along, b.along) : never;
    };
    std::vector<Side> sides;
    for (const Contact& contact : geometry.contacts)
        for (const bool turned : {false, true}) {
            const Station &leaves = turned ? contact.other : contact.one, &comes = turned ? contact.one : contact.other;
            sides.push_back({leaves, comes, contact.apart, along(from, leaves) + contact.apart, false});
        }
    double best = along(from, to);
    for (;;) {
        Side* next = nullptr;
        for (Side& side : sides)
            if (!side.done && side.way < never && (next == nullptr || side.way < next->way)) next = &side;
        if (next == nullptr) return best;
        next->done = true;
        best = std::min(best, next->way + along(next->comes, to));
        for (Side& side : sides) side.way = std::min(side.way, next->way + along(next->comes, side.leaves) + side.apart);
    }
}

// Broken lines that cross and run on each other, some of them closed.
Page thicket(unsigned seed, int lines, double width) {
    Dice chance(seed);
    Page page = blank_page();
    for (int i = 0; i < lines; ++i) {
        const Point from{chance.between(60, 100), chance.between(60, 100)};
        add_line(page, wandering_line(chance, from, 5, 14), width, i % 5 == 0);
    }
    return page;
}

TEST(InkWay, IsTheOneByGoingEverywhere) {
    int joined = 0, asked = 0;
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const Page page = thicket(seed, 6 + static_cast<int>(seed), 0.4 + 0.1 * seed);
        const PageGeometry geometry(page);
        InkWays ways(geometry);
        Dice chance(seed);
        const auto station = [&] {
            const std::size_t chain = chance.below(geometry.chains.size());
            return Station{chain, chance.between(0, geometry.chains[chain].length)};
        };
        for (int i = 0; i < 40; ++i) {
            const Station from = station(), to = station();
            const double way = naive_way(geometry, from, to);
            for (const double most : {2.0, 6.0, 12.0, 25.0, way - 0.001, way + 0.001}) {
                if (!(most > 0) || most > 30) continue;
                EXPECT_EQ(ways.joined_within(from, to, most), way <= most) << seed << " " << i << " " << way << " " << most;
                ++asked;
                joined += way <= most;
            }
        }
        EXPECT_FALSE(ways.exhausted());
    }
    EXPECT_GT(joined, asked / 10);
    EXPECT_LT(joined, asked * 9 / 10);
}

// What needs no search tells of no way that there is not, and of some that lead through one contact.
TEST(InkWay, ThroughOneContactIsToldWithoutASearch) {
    int told = 0, not_told = 0;
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const Page page = thicket(seed, 6 + static_cast<int>(seed), 0.4 + 0.1 * seed);
        const PageGeometry geometry(page);
        const InkWays ways(geometry);
        Dice chance(seed + 60);
        for (std::size_t c = 0; c < geometry.contacts.size(); c += 5) {
            const Contact& contact = geometry.contacts[c];
            if (contact.one.chain == contact.other.chain) continue;
            const auto beside = [&](const Station& at) {
                const double length = geometry.chains[at.chain].length;
                return Station{at.chain, std::clamp(at.along + chance.between(-2, 2), 0.0, length)};
            };
            const Station from = beside(contact.one), to = beside(contact.other);
            const double way = naive_way(geometry, from, to), most = way + chance.between(-1, 2);
            EXPECT_EQ(ways.touch_within(from, to, most), ways.touch_within(to, from, most));
            EXPECT_FALSE(way > most && ways.touch_within(from, to, most)) << seed << " " << c << " " << way << " " << most;
            ++(ways.touch_within(from, to, most) ? told : not_told);
        }
    }
    EXPECT_GT(told, 30);
    EXPECT_GT(not_told, 100);
}

// That it is farther than so much from one place says less of those beside it.
TEST(InkWay, IsToldAnewForPlacesBesideEachOther) {
    int asked = 0;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const Page page = thicket(seed, 8 + static_cast<int>(seed), 0.4 + 0.1 * seed);
        const PageGeometry geometry(page);
        InkWays ways(geometry);
        Dice chance(seed + 40);
        for (int i = 0; i < 40; ++i) {
            const std::size_t one = chance.below(geometry.chains.size()), other = chance.below(geometry.chains.size());
            const auto beside = [&](std::size_t chain, double along) {
                return Station{chain, std::clamp(along + chance.between(-3, 3), 0.0, geometry.chains[chain].length)};
            };
            const Station from = beside(one, chance.between(0, 70)), to = beside(other, chance.between(0, 70));
            for (int k = 0; k < 12; ++k) {
                if (const double first = naive_way(geometry, from, to); first < 40) ways.joined_within(from, to, first - 0.001);
                const Station near = beside(one, from.along), there = beside(other, to.along);
                const double way = naive_way(geometry, near, there);
                if (way > 40 || way < 0.01) continue;
                EXPECT_TRUE(ways.joined_within(near, there, way + 0.001)) << seed << " " << i << " " << way;
                EXPECT_FALSE(ways.joined_within(near, there, way - 0.001)) << seed << " " << i << " " << way;
                ++asked;
            }
        }
    }
    EXPECT_GT(asked, 100);
}

// From any place of a piece to any of another; a way that does not leave their line is not through contacts.
TEST(InkWay, IsNotDeniedWhereThereIsOne) {
    int denied = 0, ways_there = 0;
    for (unsigned seed = 1; seed <= 8; ++seed) {
        const Page page = thicket(seed, 5 + static_cast<int>(seed), 0.4 + 0.1 * seed);
        const PageGeometry geometry(page);
        const InkWays ways(geometry);
        Dice chance(seed + 20);
        for (int i = 0; i < 60; ++i) {
            const std::size_t one = chance.below(geometry.pieces.size()), other = chance.below(geometry.pieces.size());
            const auto station = [&](std::size_t number) {
                const Piece& piece = geometry.pieces[number];
                return Station{piece.chain, piece.along + chance.between(0, distance(piece.line.a, piece.line.b))};
            };
            if (geometry.pieces[one].chain == geometry.pieces[other].chain) continue;
            const double way = naive_way(geometry, station(one), station(other));
            for (const double most : {3.0, 10.0, 20.0}) {
                if (way <= most) {
                    EXPECT_TRUE(ways.may_join(one, other, most)) << seed << " " << i << " " << way << " " << most;
                    ++ways_there;
                }
                denied += !ways.may_join(one, other, most);
            }
        }
    }
    EXPECT_GT(ways_there, 50);
    EXPECT_GT(denied, 50);
}

// Lines that lie on each other touch in many places, each of which could be gone on from.
TEST(InkWay, IsFoundThroughLinesThatLieOnEachOther) {
    Page page = blank_page();
    add_line(page, {{20, 50}, {70, 50}}, 1.5);
    for (int i = 1; i <= 8; ++i) add_line(page, {{70, 50 + 0.5 * i}, {90, 50 + 0.5 * i}}, 1.5);
    add_line(page, {{20, 54}, {70, 54}}, 1.5);
    const PageGeometry geometry(page);
    InkWays ways(geometry);
    EXPECT_TRUE(ways.joined_within({0, 46}, {9, 46}, 12.2));
    EXPECT_FALSE(ways.joined_within({0, 46}, {9, 46}, 10));
}

}  // namespace
}  // namespace tactics::ink_way_test
