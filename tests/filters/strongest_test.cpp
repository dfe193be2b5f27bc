// SPDX-License-Identifier: Apache-2.0
// The line budget: which edges stay.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "filters/edge_map.h"
#include "filters/list.h"
#include "tactics/recipe.h"

namespace tactics::strongest_test {
namespace {

EdgeMap map_of(int width, int height, double mm_per_pixel) {
    EdgeMap map{width, height, mm_per_pixel, true, {}, {}};
    map.strength.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0f);
    return map;
}

float& at(EdgeMap& map, int x, int y) {
    return map.strength[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(x)];
}

void draw_row(EdgeMap& map, int y, int from, int to, float strength) {
    for (int x = from; x < to; ++x) at(map, x, y) = strength;
}

EdgeMap kept(const std::string& step, const EdgeMap& map) {
    return std::get<EdgeMap>(run(parse_recipe(step, "test", filters()), Artwork{map}));
}

std::size_t pixels(const EdgeMap& map) {
    return static_cast<std::size_t>(std::count_if(map.strength.begin(), map.strength.end(), [](float s) { return s > 0; }));
}

// A map like a photograph's: thin wandering lines whose strength rises and falls.
EdgeMap wandering(std::uint32_t seed, int lines) {
    EdgeMap map = map_of(200, 150, 0.5);
    std::mt19937 random(seed);
    const auto below = [&](int most) { return static_cast<double>(random() % 1000) * most / 1000; };
    for (int i = 0; i < lines; ++i) {
        double x = below(200), y = below(150), angle = below(7), strength = 5 + below(50);
        for (int k = 0; k < 120; ++k) {
            x += std::cos(angle);
            y += std::sin(angle);
            angle += (below(100) - 50) / 300;
            strength = std::max(1.0, strength + (below(100) - 50) / 25);
            if (x >= 0 && y >= 0 && x < 200 && y < 150)
                at(map, static_cast<int>(x), static_cast<int>(y)) = static_cast<float>(strength);
        }
    }
    return map;
}

TEST(Strongest, KeepsToTheBudgetAndWithoutGapsMoreOnlyAdds) {
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        const EdgeMap map = wandering(seed, 40);
        const double room = std::pow(std::sqrt(100.0 * 75) / 63, 5.0 / 3);  // against the square of 63 mm
        EdgeMap before = map_of(200, 150, 0.5);
        for (const double line : {20.0, 75.0, 150.0, 400.0, 1000.0, 100'000.0}) {
            const EdgeMap after = kept("strongest gap=0 line=" + std::to_string(line), map);
            // At most 1.42 and at least 1 mm of line for a millimetre of pixels; a line of steps is 1.11 on the mean.
            EXPECT_LE(0.5 * 1.11 * static_cast<double>(pixels(after)), line * room + 1);
            for (std::size_t i = 0; i < map.strength.size(); ++i) {
                EXPECT_TRUE(after.strength[i] == 0 || after.strength[i] == map.strength[i]);
                EXPECT_TRUE(before.strength[i] == 0 || after.strength[i] > 0);
            }
            before = after;
        }
        EXPECT_EQ(before.strength, map.strength);
    }
}

// With gaps closed a larger budget may spend what a gap cost elsewhere, but it never keeps less.
TEST(Strongest, ALargerBudgetNeverKeepsLess) {
    for (const std::uint32_t seed : {1u, 2u, 3u, 4u, 5u}) {
        const EdgeMap map = wandering(seed, 40);
        std::size_t before = 0;
        for (int line = 10; line < 800; line += 20) {
            const std::size_t count = pixels(kept("strongest line=" + std::to_string(line), map));
            EXPECT_GE(count, before) << seed << ", " << line;
            before = count;
        }
    }
}

// What is drawn with one pen has one strength; whole lines are kept then, not the one pixel that is a little stronger.
TEST(Strongest, OfLinesOfOneStrengthTheLongestAreKept) {
    EdgeMap map = map_of(126, 126, 0.5);
    for (int i = 0; i < 12; ++i) draw_row(map, 5 + 10 * i, 0, 20 + 8 * i, 30);
    at(map, 3, 5) = 31;
    const EdgeMap after = kept("strongest line=100mm", map);
    const double budget = 100 / (0.5 * 1.11);
    EXPECT_LE(pixels(after), budget);
    EXPECT_GE(pixels(after), budget / 2);
    for (int i = 0; i < 12; ++i) {
        const auto row =
            std::count_if(&after.strength[static_cast<std::size_t>((5 + 10 * i) * 126)],
                          &after.strength[static_cast<std::size_t>((6 + 10 * i) * 126)], [](float s) { return s > 0; });
        EXPECT_TRUE(row <= 1 || row == 20 + 8 * i) << i;
    }
}

TEST(Strongest, ClosesGapsUpToWhatIsSaid) {
    for (const int wide : {1, 2, 3, 4, 5, 6, 9}) {
        EdgeMap map = map_of(126, 126, 1);
        draw_row(map, 20, 10, 90, 50);
        draw_row(map, 20, 40, 40 + wide, 10);
        draw_row(map, 60, 0, 126, 10);  // more than the budget has room for
        for (const int gap : {wide - 1, wide}) {
            // A little more than whole pixels of 1.11 mm, so that rounding does not matter.
            const EdgeMap after = kept("strongest line=30mm gap=" + std::to_string(1.1108 * gap + 0.01), map);
            EXPECT_EQ(pixels(after), static_cast<std::size_t>(gap == wide ? 80 : 80 - wide)) << wide << ", " << gap;
        }
    }
}

TEST(Strongest, WhatIsNoNumberIsNoEdge) {
    EdgeMap map = map_of(126, 126, 0.5);
    draw_row(map, 20, 10, 110, std::numeric_limits<float>::quiet_NaN());
    draw_row(map, 60, 10, 110, std::numeric_limits<float>::infinity());
    EXPECT_EQ(pixels(kept("strongest line=200mm", map)), 100u);
    for (const float s : kept("strongest line=200mm", map).strength) EXPECT_FALSE(std::isnan(s));
}

TEST(Strongest, KeepsTheStrongest) {
    const EdgeMap map = wandering(7, 40), after = kept("strongest gap=0 line=100mm", map);
    float least = 1e9f, most = 0;
    for (std::size_t i = 0; i < map.strength.size(); ++i)
        if (after.strength[i] > 0)
            least = std::min(least, map.strength[i]);
        else
            most = std::max(most, map.strength[i]);
    EXPECT_GT(pixels(after), 100u);
    EXPECT_LE(most, least);
}

TEST(Strongest, ALineIsNotBrokenByAShortWeakPart) {
    // 100 mm of budget are too little for all; of the weak rows one lies between two strong ones.
    EdgeMap map = map_of(126, 126, 0.5);
    draw_row(map, 20, 10, 110, 50);
    draw_row(map, 20, 50, 70, 10);  // 20 pixels, 11 mm
    draw_row(map, 60, 10, 50, 10);  // weak altogether
    draw_row(map, 100, 0, 30, 50);
    draw_row(map, 100, 30, 90, 10);  // 60 pixels, 33 mm: too long a gap
    draw_row(map, 100, 90, 120, 50);
    const auto row = [](EdgeMap edges, int y) {
        return std::count_if(&at(edges, 0, y), &at(edges, 0, y) + edges.width, [](float s) { return s > 0; });
    };
    const EdgeMap closed = kept("strongest line=100mm", map), open = kept("strongest line=100mm gap=0", map);
    EXPECT_EQ(row(closed, 20), 100);
    EXPECT_EQ(row(closed, 60), 0);
    EXPECT_EQ(row(closed, 100), 60);
    EXPECT_EQ(row(open, 20), 80);
    EXPECT_EQ(row(open, 100), 60);
    EXPECT_EQ(row(kept("strongest line=130mm gap=40mm", map), 100), 120);
}

TEST(Strongest, AGapInALoopIsClosedFromBothEnds) {
    EdgeMap ring = map_of(126, 126, 0.5);
    for (int i = 0; i < 720; ++i)
        at(ring, static_cast<int>(std::lround(63 + 40 * std::cos(i * std::numbers::pi / 360))),
           static_cast<int>(std::lround(63 + 40 * std::sin(i * std::numbers::pi / 360)))) = 30;
    for (int y = 50; y < 76; ++y)
        for (int x = 100; x < 126; ++x)
            if (at(ring, x, y) > 0) at(ring, x, y) = 5;
    const std::size_t whole = pixels(ring);
    draw_row(ring, 5, 0, 126, 4);                                               // more than the budget has room for
    EXPECT_GE(pixels(kept("strongest line=140mm gap=20mm", ring)), whole - 3);  // corners may be cut
    EXPECT_LT(pixels(kept("strongest line=140mm gap=5mm", ring)), whole - 15);
}

// There is always a strongest: a picture does not become empty for having one line longer than the budget.
TEST(Strongest, KeepsALineOfOneStrengthWhole) {
    EdgeMap map = map_of(126, 126, 0.5);
    draw_row(map, 20, 0, 126, 9);
    EXPECT_EQ(pixels(kept("strongest line=5mm", map)), 126u);
    EXPECT_EQ(pixels(kept("strongest", map_of(30, 30, 0.5))), 0u);
}

}  // namespace
}  // namespace tactics::strongest_test
