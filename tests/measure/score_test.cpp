// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/score.h"

#include <gtest/gtest.h>

#include "tactics/measure/evaluation.h"

namespace tactics::score_test {
namespace {

constexpr int kWidth = 400, kHeight = 300;  // a reach of 3.75 pixels

PixelSet column(int x, int from = 0, int to = kHeight) {
    PixelSet set{kWidth, kHeight, {}};
    for (int y = from; y < to; ++y) set.pixels.push_back(static_cast<std::uint32_t>(y * kWidth + x));
    return set;
}

EdgeMap lines() {
    EdgeMap map;
    map.width = kWidth;
    map.height = kHeight;
    map.strength.assign(static_cast<std::size_t>(kWidth) * kHeight, 0.0f);
    return map;
}

void draw(EdgeMap& map, const PixelSet& set, float strength) {
    for (const std::uint32_t pixel : set.pixels) map.strength[pixel] = strength;
}

TEST(Score, KnowsWhatWasFoundAndWhatIsRight) {
    EdgeMap map = lines();
    draw(map, column(100), 100);
    draw(map, column(200), 10);
    // One drew the strong line twice as far off as may be, the other drew it 3 pixels off, and half of a third line.
    const std::vector<PixelSet> people{column(108), column(103), column(300, 0, 150)};
    const auto curve = score_at_levels(map, people);
    ASSERT_EQ(curve.size(), levels().size());
    EXPECT_EQ(levels().back(), 0);
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const int drawn = levels()[i] > 100 ? 0 : levels()[i] > 10 ? 300 : 600;
        EXPECT_EQ(curve[i].lines, drawn) << levels()[i];
        EXPECT_EQ(curve[i].right, drawn > 0 ? 300 : 0);
        EXPECT_EQ(curve[i].found, drawn > 0 ? 300 : 0);
        EXPECT_EQ(curve[i].truth, 750);
    }
    EXPECT_DOUBLE_EQ(curve.back().precision(), 0.5);
    EXPECT_DOUBLE_EQ(curve.back().recall(), 0.4);
    EXPECT_DOUBLE_EQ(curve.back().f(), 2 * 0.5 * 0.4 / 0.9);
    EXPECT_EQ(Counts{}.f(), 0);
}

TEST(Score, ALineIsRightOnceHoweverManyDrewIt) {
    EdgeMap map = lines();
    draw(map, column(100), 100);
    const std::vector<PixelSet> people{column(100), column(101)};
    const Counts all = score_at_levels(map, people).back();
    EXPECT_EQ(all.right, 300);
    EXPECT_EQ(all.found, 600);
}

TEST(Score, LinesAreThinnedFirst) {
    EdgeMap map = lines();
    for (int x = 98; x < 103; ++x) draw(map, column(x), 50);
    const std::vector<PixelSet> people{column(100)};
    const Counts all = score_at_levels(map, people).back();
    EXPECT_LE(all.lines, 300);
    EXPECT_GE(all.lines, 295);
    EXPECT_EQ(all.right, all.lines);
}

TEST(Score, PeopleAreScoredAgainstEachOther) {
    const std::vector<PixelSet> same{column(100), column(100)}, apart{column(100), column(200)};
    EXPECT_DOUBLE_EQ(score_people(same).f(), 1);
    EXPECT_EQ(score_people(apart).f(), 0);
    // Two agree, the third stands alone: two thirds of all lines are right, and of six comparisons two are met.
    const std::vector<PixelSet> three{column(100), column(101), column(200)};
    EXPECT_DOUBLE_EQ(score_people(three).precision(), 2.0 / 3);
    EXPECT_DOUBLE_EQ(score_people(three).recall(), 1.0 / 3);
    EXPECT_EQ(score_people(std::vector<PixelSet>{column(1)}).truth, 0);
}

Trial trial_of(const std::vector<std::pair<std::size_t, Counts>>& peaks) {
    Trial trial;
    trial.curve.assign(levels().size(), Counts{0, 100, 0, 100});
    for (const auto& [level, counts] : peaks) trial.curve[level] = counts;
    return trial;
}

TEST(Figures, OneDialForAllOrOneForEach) {
    RecipeResult result{"r", {"a", "b"}, {}};
    // The first picture is best at level 3, the second at level 5 of setting b; there they are fair together.
    result.trials.push_back({trial_of({{3, {90, 100, 90, 100}}}), trial_of({{5, {60, 100, 60, 100}}})});
    result.trials.push_back({trial_of({}), trial_of({{5, {80, 100, 80, 100}}})});
    result.trials[0][1].touch = TouchLoad{100, 4, 25};
    result.trials[1][1].touch = TouchLoad{300, 8, 75};
    result.trials[0][1].recipe_ms = 1;
    result.trials[1][1].recipe_ms = 4;
    // A picture that could not be scored counts as that and nowhere else.
    result.trials.push_back({trial_of({}), Trial{}});
    result.trials[2][1].error = "broken";
    const Figures figures = figures_of(result);
    EXPECT_DOUBLE_EQ(figures.best.f(), 0.7);
    EXPECT_EQ(figures.dial.setting, 1u);
    EXPECT_EQ(figures.dial.level, 5u);
    EXPECT_DOUBLE_EQ(figures.best_each.f(), 0.85);
    EXPECT_EQ(figures.scored, 2u);
    EXPECT_EQ(figures.failed, 1u);
    EXPECT_DOUBLE_EQ(figures.length, 200);
    EXPECT_DOUBLE_EQ(figures.strokes, 6);
    EXPECT_DOUBLE_EQ(figures.crowded, 0.25);
    EXPECT_DOUBLE_EQ(figures.recipe_ms, 2.5);
}

}  // namespace
}  // namespace tactics::score_test
