// SPDX-License-Identifier: Apache-2.0
// Bars of charts in pictures: found, told apart, and named by their legend.
#include "filters/inked_bars.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include "filters/darken.h"
#include "filters/inked_legend.h"
#include "filters/known_parts.h"
#include "tests/filters/pictures.h"

namespace tactics::inked_bars_test {
namespace {

constexpr PixelColour kWhite{255, 255, 255};

using Fill = std::function<int(int, int)>;
const Fill kRising = [](int x, int y) { return (x + y) % 12 < 2 ? 0 : 255; };
const Fill kFalling = [](int x, int y) { return (x - y + 1200) % 12 < 2 ? 0 : 255; };
const Fill kLevel = [](int, int y) { return y % 9 < 1 ? 0 : 255; };
const Fill kUprightLines = [](int x, int) { return x % 9 < 1 ? 0 : 255; };
const Fill kChecks = [](int x, int y) { return (x + y) % 2 == 0 ? 90 : 200; };
const Fill kGrey = [](int, int) { return 150; };
const Fill kBlank = [](int, int) { return 255; };

struct DrawnBar {
    int left, top, right, bottom;
    Fill fill;
};

// Each with a black outline of one pixel; `beneath` is the ground, such as a grid.
Image with_bars(int width, int height, const std::vector<DrawnBar>& bars, const Fill& beneath = kBlank) {
    return pictures::drawn(width, height, [&](int x, int y) {
        int level = beneath(x, y);
        for (const DrawnBar& b : bars) {
            if (x < b.left || x > b.right || y < b.top || y > b.bottom) continue;
            level = x == b.left || x == b.right || y == b.top || y == b.bottom ? 0 : b.fill(x, y);
        }
        return level;
    });
}

std::vector<DrawnBar> beside(const std::vector<Fill>& fills) {
    const int tops[] = {60, 120, 40, 90, 150, 70};
    std::vector<DrawnBar> bars;
    for (int i = 0; i < 6; ++i)
        bars.push_back({40 + 70 * i, tops[i], 90 + 70 * i, 250, fills[static_cast<std::size_t>(i) % fills.size()]});
    return bars;
}

// Which of the found bars each drawn one is; -1 for none.
std::vector<int> numbers_of(const std::vector<DrawnBar>& drawn, const InkedBars& found) {
    std::vector<int> numbers;
    for (const DrawnBar& b : drawn) {
        const auto is_it = [&](const InkedBar& f) {
            return std::abs(f.left - b.left) < 4 && std::abs(f.top - b.top) < 4 && std::abs(f.right - b.right) < 4 &&
                   std::abs(f.bottom - b.bottom) < 4;
        };
        const auto at = std::find_if(found.bars.begin(), found.bars.end(), is_it);
        numbers.push_back(at == found.bars.end() ? -1 : static_cast<int>(at - found.bars.begin()));
    }
    return numbers;
}

void expect_found(const std::vector<DrawnBar>& drawn, const Image& picture, std::size_t kinds) {
    const auto found = inked_bars_in(picture, kWhite, pictures::kPixel);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->fills.size(), kinds);
    EXPECT_EQ(found->bars.size(), drawn.size());
    const std::vector<int> numbers = numbers_of(drawn, *found);
    std::vector<std::set<std::size_t>> of_kind(kinds);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        ASSERT_GE(numbers[i], 0) << i;
        of_kind[i % kinds].insert(found->bars[static_cast<std::size_t>(numbers[i])].fill);
    }
    std::set<std::size_t> all;
    for (const auto& one : of_kind) {
        EXPECT_EQ(one.size(), 1u);
        all.insert(one.begin(), one.end());
    }
    EXPECT_EQ(all.size(), kinds);
}

TEST(InkedBars, AreFoundWithAnyFill) {
    for (const auto& fills :
         {std::vector<Fill>{kRising, kFalling}, {kLevel, kUprightLines, kGrey}, {kChecks, kRising}, {kGrey, kBlank}})
        expect_found(beside(fills), with_bars(480, 300, beside(fills)), fills.size());
}

TEST(InkedBars, MayLieAndStandOnEachOther) {
    std::vector<DrawnBar> bars;
    for (int i = 0; i < 4; ++i) {
        const int middle = 150 + 20 * i;
        bars.push_back({30, 30 + 60 * i, middle, 70 + 60 * i, kRising});
        bars.push_back({middle, 30 + 60 * i, middle + 90, 70 + 60 * i, kGrey});
    }
    const Image picture = with_bars(400, 300, bars);
    expect_found(bars, picture, 2);
    EXPECT_TRUE(inked_bars_in(picture, kWhite, pictures::kPixel)->lying);
}

// A line of a grid over the bars does not part them, and what it encloses between them is no bar.
TEST(InkedBars, AreWholeOverAGrid) {
    std::vector<DrawnBar> bars;
    for (int i = 0; i < 6; ++i) bars.push_back({40 + 60 * i, 60 + 17 * i, 70 + 60 * i, 250, kGrey});
    Image picture = with_bars(440, 300, bars);
    for (int y = 50; y < 250; y += 40)
        for (int x = 10; x < 430; ++x) picture.row(y)[x] = 200;
    expect_found(bars, picture, 1);
    for (int y = 20; y < 250; ++y) picture.row(y)[55] = 80;  // within a bar, as far as its ends
    take_out(picture, kWhite, *inked_bars_in(picture, kWhite, pictures::kPixel));
    for (int x = 45; x < 66; ++x) EXPECT_EQ(picture.row(150)[x], 255) << x;
}

// From end to end; a whisker that ends within the bar stays.
TEST(InkedBars, LeaveNoLineOfAGridWithinThem) {
    Image picture = with_bars(200, 300, {{40, 50, 100, 250, kGrey}});
    InkedBars found;
    found.bars = {{40.5, 50.5, 100.5, 250.5, 0}};
    found.fills = {{CellFill::colour, {150, 150, 150}, 0.4, 0, 0, {}, {}}};
    found.base = 250.5;
    for (int y = 20; y < 280; ++y) picture.row(y)[60] = 40;
    for (int y = 20; y < 150; ++y) picture.row(y)[80] = 40;
    take_out(picture, kWhite, found);
    EXPECT_EQ(picture.row(120)[60], 255);
    EXPECT_LT(picture.row(120)[80], 128);
}

TEST(InkedBars, AreNoSquaresOfAPlotNorBoxesOfADiagram) {
    std::vector<DrawnBar> squares, boxes;
    for (int i = 0; i < 6; ++i) squares.push_back({40 + 60 * i, 80, 58 + 60 * i, 98, kGrey});
    for (int i = 0; i < 5; ++i) boxes.push_back({40 + 80 * i, 80, 100 + 80 * i, 160, kBlank});
    EXPECT_FALSE(inked_bars_in(with_bars(440, 300, squares), kWhite, pictures::kPixel));
    EXPECT_FALSE(inked_bars_in(with_bars(480, 300, boxes), kWhite, pictures::kPixel));
    for (DrawnBar& box : boxes) box.fill = kGrey;
    EXPECT_FALSE(inked_bars_in(with_bars(480, 300, boxes), kWhite, pictures::kPixel));
    std::vector<DrawnBar> table;
    for (int i = 0; i < 12; ++i) {
        const int column = i % 4, row = i / 4;
        table.push_back({40 + 90 * column, 30 + 70 * row, 130 + 90 * column, 100 + 70 * row,
                         i % 3 == 0   ? kGrey
                         : i % 3 == 1 ? kRising
                                      : kFalling});
    }
    EXPECT_FALSE(inked_bars_in(with_bars(480, 300, table), kWhite, pictures::kPixel));
    // Points over each other, on the lines of a grid, so that their sides are straight.
    const Image points = pictures::drawn(440, 300, [](int x, int y) {
        for (int i = 0; i < 6; ++i)
            for (const int on : {100, 150, 130 + 14 * i})
                if (std::hypot(x - 60 - 60 * i, y - on) < 11) return 0;
        return x % 60 == 0 || y % 50 == 0 ? 200 : 255;
    });
    EXPECT_FALSE(inked_bars_in(points, kWhite, pictures::kPixel));
    const Image tiny = pictures::drawn(3, 2, [](int x, int) { return x * 90; });
    EXPECT_FALSE(inked_bars_in(tiny, kWhite, 60));
}

// A line over bars, in colour or hatched, stays; the bars go.
TEST(InkedBars, LeaveTheLineThatCrossesThem) {
    for (const Fill& fill : {kGrey, kRising, kLevel}) {
        const std::vector<DrawnBar> bars = beside({fill});
        Image picture = with_bars(480, 300, bars);
        const auto on_line = [](int x) { return 200 - x / 4; };
        for (int x = 10; x < 470; ++x)
            for (int y = on_line(x); y < on_line(x) + 4; ++y) picture.row(y)[x] = 0;
        const auto found = inked_bars_in(picture, kWhite, pictures::kPixel);
        ASSERT_TRUE(found);
        take_out(picture, kWhite, *found);
        int there = 0, left = 0;
        for (int x = 10; x < 470; ++x) {
            const int y = on_line(x);
            there += picture.row(y + 1)[x] < 128 || picture.row(y + 2)[x] < 128 ? 1 : 0;
            for (int v = 0; v < 300; ++v) left += picture.row(v)[x] < 200 && std::abs(v - y) > 8 ? 1 : 0;
        }
        EXPECT_GT(there, 0.9 * 460);
        EXPECT_LT(left, 60);
    }
}

BarFill hatch_of(double dark, double marks) { return {CellFill::hatch, kWhite, dark, marks, 0, {}, {1, 0, 0, 0, 0, 0, 0, 0}}; }

// One of the bars, and one in a group that lacks another one, look like neither kind.
TEST(BarFills, FollowEachOtherInAllGroupsAsInMost) {
    const BarFill pale = hatch_of(0.1, 0.05), deep = hatch_of(0.4, 0.2), odd = hatch_of(0.2, 0.08);
    const std::vector<BarFill> fills{pale, deep, pale, deep, pale, odd, pale, deep, odd};
    BarKinds kinds = kinds_of(fills, std::vector<double>(fills.size(), 1));
    EXPECT_EQ(kinds.fills.size(), 3u);
    even_out(kinds, fills, {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {8}});
    EXPECT_EQ(kinds.fills.size(), 2u);
    EXPECT_EQ(kinds.of[5], kinds.of[1]);
    EXPECT_EQ(kinds.of[8], kinds.of[0]);
    // A colour is what it is.
    std::vector<BarFill> colours(6, BarFill{CellFill::colour, {200, 0, 0}, 0.5, 0, 0, {}, {}});
    for (const std::size_t i : {1u, 3u}) colours[i].colour = {0, 0, 200};
    colours[5].colour = {0, 200, 0};
    BarKinds three = kinds_of(colours, std::vector<double>(6, 1));
    even_out(three, colours, {{0, 1}, {2, 3}, {4, 5}});
    EXPECT_EQ(three.fills.size(), 3u);
}

// Two hatches in a legend, that only their direction tells apart.
TEST(BarLegend, EachHatchIsNamedAtBarsOfItsOwn) {
    std::vector<DrawnBar> bars = beside({kRising, kFalling});
    std::vector<LegendWords> words;
    for (int i = 0; i < 2; ++i) {
        bars.push_back({60 + 150 * i, 8, 90 + 150 * i, 22, i == 0 ? kFalling : kRising});
        words.push_back({{100 + 150 * i, 9, 150 + 150 * i, 21}, 12});
    }
    const std::vector<LegendEntry> entries = legend_in(with_bars(480, 300, bars), words);
    ASSERT_EQ(entries.size(), 2u);
    for (const LegendEntry& entry : entries) {
        const auto bar = static_cast<std::size_t>((entry.at.x - 40) / 70);
        EXPECT_EQ(bar % 2, entry.words == 0 ? 1u : 0u);
        EXPECT_LT(std::abs(entry.at.y - bars[bar].top), 4) << "at its end";
    }
    // Of two samples that look alike none says anything.
    bars[7].fill = kFalling;
    EXPECT_TRUE(legend_in(with_bars(480, 300, bars), words).empty());
    // Nor where one of them is too small to show its marks.
    bars[7].fill = kBlank;
    EXPECT_TRUE(legend_in(with_bars(480, 300, bars), words).empty());
}

// Their samples are to the left, but as far from the words before.
TEST(BarLegend, AllWordsHaveTheirSamplesOnOneSide) {
    std::vector<DrawnBar> bars = beside({kGrey, kRising, kFalling});
    std::vector<LegendWords> words;
    const Fill fills[] = {kGrey, kRising, kFalling};
    for (int i = 0; i < 3; ++i) {
        bars.push_back({60 + 100 * i, 8, 90 + 100 * i, 22, fills[i]});
        words.push_back({{104 + 100 * i, 9, 148 + 100 * i, 21}, 12});
    }
    const std::vector<LegendEntry> entries = legend_in(with_bars(480, 300, bars), words);
    ASSERT_EQ(entries.size(), 3u);
    for (const LegendEntry& entry : entries) EXPECT_EQ(static_cast<std::size_t>((entry.at.x - 40) / 70) % 3, entry.words);
}

TEST(KnownParts, BarsOfBlackAndWhiteDrawingsAreDrawnAsSuch) {
    Image picture = with_bars(480, 300, beside({kRising, kFalling}));
    const KnownParts parts = take_known_parts(picture);
    EXPECT_GT(parts.strokes.size(), 6u * 3);
    EXPECT_TRUE(std::all_of(picture.pixels.begin(), picture.pixels.end(), [](int level) { return level == 255; }));
}

}  // namespace
}  // namespace tactics::inked_bars_test
