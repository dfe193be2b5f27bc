// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/repeats.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/information/sources.h"

namespace tactics::tests::repeats_test {
namespace {

int at(const LevelGrid& grid, int x, int y) {
    return grid.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(x)];
}

bool holds(const LevelGrid& grid, const Shift& shift) {
    for (int y = shift.down; y < grid.rows; ++y)
        for (int x = std::max(0, shift.aside); x < std::min(grid.columns, grid.columns + shift.aside); ++x)
            if (at(grid, x, y) != at(grid, x - shift.aside, y - shift.down)) return false;
    return true;
}

int cells_of(const LevelGrid& grid, const Shift& shift) {
    return shift.down * grid.columns + std::abs(shift.aside) * (grid.rows - shift.down);
}

// Whatever the factors, and wherever it is cut.
TEST(Repeats, AnEnlargedGridIsReducedToItsSource) {
    const LevelGrid small = noise(40, 30, 16, 4);
    for (const int across : {1, 2, 7})
        for (const int down : {2, 3})
            for (const int off : {0, 1}) {
                const LevelGrid large = grid_by(40 * across - off, 30 * down - off, 16,
                                                [&](int x, int y) { return at(small, (x + off) / across, (y + off) / down); });
                const auto found = reduced(large);
                ASSERT_TRUE(found) << across << " " << down;
                const int first = across == 1 ? off : 0;  // of one column to each what is cut off is gone
                ASSERT_EQ(found->grid.columns, 40 - first);
                ASSERT_EQ(found->grid.rows, 30);
                for (int y = 0; y < 30; ++y)
                    for (int x = first; x < 40; ++x) ASSERT_EQ(at(found->grid, x - first, y), at(small, x, y));
                EXPECT_LT(found->said, 40);
            }
}

TEST(Repeats, EnlargedUnevenlyItIsStillReduced) {
    const LevelGrid small = noise(40, 30, 16, 4);
    const auto found = reduced(grid_by(97, 79, 16, [&](int x, int y) { return at(small, x * 40 / 97, y * 30 / 79); }));
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->grid.values == small.values);
    EXPECT_GT(found->said, 60);  // where each row and column begins has to be said
    const auto hardly = reduced(grid_by(44, 32, 16, [&](int x, int y) { return at(small, x * 40 / 44, y * 30 / 32); }));
    ASSERT_TRUE(hardly);
    EXPECT_TRUE(hardly->grid.values == small.values);
}

TEST(Repeats, WhatHasNoTwinsIsNotReduced) {
    EXPECT_FALSE(reduced(noise(60, 50, 2, 1)));
    EXPECT_FALSE(reduced(LevelGrid{4, 4, 4, 2, words_of(noise(64, 1, 2, 1))}));
}

// As looking at all shifts one by one does.
TEST(Repeats, TheShiftIsTheBestOfAll) {
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        RandomNumbers random(seed);
        const int across = 1 + static_cast<int>(random.below(9)), down = 1 + static_cast<int>(random.below(9)),
                  slant = static_cast<int>(random.below(5)) - 2;
        const LevelGrid tile = noise(across, down, 2, seed);
        const LevelGrid grid = grid_by(37, 29, 2, [&](int x, int y) {
            const int turned = x + y / down * slant + 1000 * across;
            return at(tile, turned % across, y % down);
        });
        int best = grid.columns * grid.rows;
        for (int below = 0; below <= 14; ++below)
            for (int aside = below > 0 ? -18 : 1; aside <= 18; ++aside)
                if (holds(grid, {aside, below})) best = std::min(best, cells_of(grid, {aside, below}));
        const auto shift = shift_of(grid);
        if (!shift) {  // a tile of one level
            EXPECT_EQ(words_of(grid), std::vector<std::uint16_t>(grid.count(), grid.values[0])) << seed;
            continue;
        }
        ++found;
        EXPECT_TRUE(holds(grid, *shift));
        EXPECT_EQ(cells_of(grid, *shift), best) << seed;
        int cells = 0;
        for (const LevelGrid& border : borders_of(grid, *shift)) cells += static_cast<int>(border.count());
        EXPECT_EQ(cells, best);
    }
    EXPECT_GT(found, 50);
}

TEST(Repeats, OneOtherCellIsNoShift) {
    std::vector<std::uint16_t> words = words_of(grid_by(300, 200, 4, [](int x, int y) { return (x + 2 * y) / 5 % 4; }));
    EXPECT_TRUE(shift_of({300, 200, 1, 4, words}));
    words[40'123] ^= 1;
    EXPECT_FALSE(shift_of({300, 200, 1, 4, words}));
}

}  // namespace
}  // namespace tactics::tests::repeats_test
