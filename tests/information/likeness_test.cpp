// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/likeness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tactics/error.h"

namespace tactics::likeness_test {
namespace {

using Grid = std::vector<std::uint8_t>;

LevelGrid grid_of(int columns, int rows, const std::function<bool(int x, int y)>& is_drawn) {
    Grid cells;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) cells.push_back(is_drawn(x, y) ? 1 : 0);
    return {columns, rows, 1, 2, std::move(cells)};
}

// A flag on a pole with a ring in it, which no turn or mirror image brings back; its lines are a 40th of `size` wide.
LevelGrid flag(int size, int left, int top, int columns, int rows) {
    return grid_of(columns, rows, [=](int x, int y) {
        const double u = static_cast<double>(x - left) / size, v = static_cast<double>(y - top) / size, line = 1.0 / 40;
        if (u < 0 || v < 0 || u > 0.8 || v > 1) return false;
        const bool pole = u < line, edge = v < 0.5 && (v < line || v > 0.5 - line || u > 0.8 - line);
        return pole || edge || std::abs(std::hypot(u - 0.25, v - 0.25) - 0.12) < line / 2;
    });
}

LevelGrid turned(const LevelGrid& grid) {  // clockwise
    return grid_of(grid.rows, grid.columns, [&](int x, int y) {
        return grid.values[static_cast<std::size_t>(grid.rows - 1 - x) * grid.columns + y] != 0;
    });
}

LevelGrid mirrored(const LevelGrid& grid) {
    return grid_of(grid.columns, grid.rows, [&](int x, int y) {
        return grid.values[static_cast<std::size_t>(y) * grid.columns + (grid.columns - 1 - x)] != 0;
    });
}

LevelGrid scribble(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::pair<double, double>> way;
    double x = 150, y = 150, course = 0;
    for (int i = 0; i < 1500; ++i) {
        course += (static_cast<double>(random() % 1000) / 1000 - 0.5) * 0.5;
        x = std::clamp(x + std::cos(course), 0.0, 299.0);
        y = std::clamp(y + std::sin(course), 0.0, 299.0);
        way.emplace_back(x, y);
    }
    Grid cells(300 * 300, 0);
    for (const auto& [px, py] : way) cells[static_cast<std::size_t>(py) * 300 + static_cast<std::size_t>(px)] = 1;
    return {300, 300, 1, 2, std::move(cells)};
}

double shared(const LevelGrid& first, const LevelGrid& second, bool any_way_up = false) {
    return likeness(look_of(first, "first"), look_of(second, "second"), any_way_up).share;
}

TEST(Likeness, OfADrawingWithItselfIsAllOfIt) {
    EXPECT_DOUBLE_EQ(shared(flag(200, 0, 0, 200, 220), flag(200, 0, 0, 200, 220)), 1);
    EXPECT_DOUBLE_EQ(shared(scribble(1), scribble(1)), 1);
    const auto line = [](int across) { return grid_of(200, 200, [=](int x, int y) { return across > 0 ? y == 90 : x == y; }); };
    EXPECT_DOUBLE_EQ(shared(line(1), line(1)), 1);
    EXPECT_LT(shared(line(1), line(0)), 0.5);
}

TEST(Likeness, DoesNotAskWhereOrHowLargeADrawingStands) {
    const LevelGrid here = flag(200, 0, 0, 200, 220);
    EXPECT_GT(shared(here, flag(200, 300, 150, 700, 500)), 0.95);
    EXPECT_GT(shared(here, flag(1000, 40, 20, 1100, 1100)), 0.8);
    EXPECT_GT(shared(here, flag(80, 3, 4, 100, 100)), 0.7);
}

TEST(Likeness, FindsTheTurnOnlyWhereItIsAskedFor) {
    const LevelGrid upright = flag(200, 10, 10, 220, 220);
    LevelGrid other = upright;
    for (int quarters = 0; quarters < 4; ++quarters) {
        for (const bool as_in_a_mirror : {false, true}) {
            const LevelGrid there = as_in_a_mirror ? mirrored(other) : other;
            const Likeness found = likeness(look_of(upright, "first"), look_of(there, "second"), true);
            EXPECT_GT(found.share, 0.9) << quarters << as_in_a_mirror;
            // It is brought back by the turn the other way; a mirror image of a turned drawing by its own.
            EXPECT_EQ(found.alignment.mirrored, as_in_a_mirror) << quarters;
            if (!as_in_a_mirror) {
                EXPECT_EQ(found.alignment.quarter_turns, (4 - quarters) % 4);
            }
            if (quarters > 0 || as_in_a_mirror) {
                EXPECT_LT(shared(upright, there), 0.5) << quarters << as_in_a_mirror;
            }
        }
        other = turned(other);
    }
}

TEST(Likeness, OfUnrelatedDrawingsIsSmall) {
    double most = 0;
    for (unsigned seed = 2; seed < 12; ++seed) most = std::max(most, shared(scribble(1), scribble(seed)));
    EXPECT_LT(most, 0.4);
    EXPECT_LT(shared(flag(200, 0, 0, 200, 220), scribble(1)), 0.35);
}

TEST(Likeness, StandsWhatIsHardlyADrawing) {
    EXPECT_THROW(look_of(grid_of(20, 20, [](int, int) { return false; }), "white.png"), Error);
    const LevelGrid dot = grid_of(20, 20, [](int x, int y) { return x == 3 && y == 7; });
    const LevelGrid black = grid_of(1, 1, [](int, int) { return true; });
    const LevelGrid line = grid_of(5000, 3, [](int, int y) { return y == 1; });
    for (const LevelGrid* first : {&dot, &black, &line})
        for (const LevelGrid* second : {&dot, &black, &line}) {
            const double share = shared(*first, *second, true);
            EXPECT_TRUE(share >= 0 && share <= 1) << share;
        }
}

}  // namespace
}  // namespace tactics::likeness_test
