// SPDX-License-Identifier: Apache-2.0
// Bars of a chart as they are felt.
#include "tactics/layout/felt_bars.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace tactics::felt_bars_test {
namespace {

ChartBars of_widths(const std::vector<std::pair<double, double>>& sides, std::size_t kinds) {
    ChartBars found;
    found.base = 200;
    for (std::size_t i = 0; i < sides.size(); ++i) found.bars.push_back({{sides[i].first, 100, sides[i].second, 200}, i % kinds});
    for (std::size_t i = 0; i < kinds; ++i) found.looks.push_back({false, false, 0.2 + 0.3 * static_cast<double>(i)});
    return found;
}

std::set<double> uprights_of(const FeltBars& felt) {
    std::set<double> at;
    for (const Stroke& stroke : felt.strokes)
        if (stroke.points.front().x == stroke.points.back().x) at.insert(stroke.points.front().x);
    return at;
}

TEST(FeltBars, ShareASideWhereAFingerFeelsNoGap) {
    EXPECT_EQ(uprights_of(felt_bars(of_widths({{10, 20}, {22, 32}, {50, 60}}, 1))), (std::set<double>{10, 21, 32, 50, 60}));
}

TEST(FeltBars, ShareASideThatWasSeenTooWide) {
    EXPECT_EQ(uprights_of(felt_bars(of_widths({{10, 21}, {20, 30}, {50, 60}}, 1))), (std::set<double>{10, 20.5, 30, 50, 60}));
}

// Thin ones take the free room between their groups; where there is none they are too thin.
TEST(FeltBars, AreAsWideAsAFingerNeeds) {
    const std::set<double> sides =
        uprights_of(felt_bars(of_widths({{10, 12}, {12, 14}, {40, 42}, {42, 44}, {70, 72}, {72, 74}}, 2)));
    EXPECT_EQ(sides, (std::set<double>{7, 12, 17, 37, 42, 47, 67, 72, 77}));
    EXPECT_TRUE(felt_bars(of_widths({{10, 12}, {12, 14}, {14, 16}, {16, 18}}, 2)).strokes.empty());
}

TEST(FeltBars, StandOnAnAxisWithoutALineOfTheirOwn) {
    ChartBars found = of_widths({{10, 20}, {30, 40}, {50, 60}}, 1);
    const std::size_t own = felt_bars(found).strokes.size();
    found.on_axis = true;
    EXPECT_EQ(own - felt_bars(found).strokes.size(), 3u);
}

TEST(FeltBars, WideOnesHaveTexturesAndNarrowOnesRungsOrBlack) {
    std::set<int> textures;
    for (const Area& area : felt_bars(of_widths({{10, 30}, {50, 70}, {90, 110}}, 3)).areas) textures.insert(area.texture);
    EXPECT_EQ(textures.size(), 3u);
    EXPECT_EQ(textures.count(0), 0u);
    const FeltBars narrow = felt_bars(of_widths({{10, 16}, {30, 36}, {50, 56}}, 3));
    ASSERT_EQ(narrow.areas.size(), 1u);  // the darkest
    EXPECT_EQ(narrow.areas[0].texture, 0);
    EXPECT_EQ(narrow.areas[0].rings[0][0].x, 50);
    const auto rungs = std::count_if(narrow.strokes.begin(), narrow.strokes.end(), [](const Stroke& stroke) {
        return stroke.points.front().y == stroke.points.back().y && stroke.points.front().x == 30 &&
               stroke.points.front().y > 101 && stroke.points.front().y < 199;
    });
    EXPECT_GT(rungs, 15);
    EXPECT_EQ(felt_bars(of_widths({{10, 16}, {30, 36}, {50, 56}, {70, 76}, {90, 96}}, 5)).areas.size(), 0u);
}

// Two lines would be felt as one.
TEST(FeltBars, LowerThanTwoLinesApartAreBlack) {
    ChartBars found = of_widths({{10, 30}, {50, 70}, {90, 110}}, 1);
    found.on_axis = true;
    found.bars[1].box.top = 198;
    const FeltBars felt = felt_bars(found);
    ASSERT_EQ(felt.areas.size(), 1u);
    EXPECT_EQ(felt.areas[0].texture, 0);
    EXPECT_EQ(uprights_of(felt), (std::set<double>{10, 30, 90, 110}));
}

}  // namespace
}  // namespace tactics::felt_bars_test
