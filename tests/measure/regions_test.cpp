// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/regions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace tactics::regions_test {
namespace {

using Labels = std::vector<std::uint32_t>;

Labels some(std::mt19937& random, std::size_t size, std::size_t regions) {
    Labels labels(size);
    for (std::uint32_t& label : labels) label = static_cast<std::uint32_t>(random() % regions);
    return labels;
}

// By the definitions, without a table.
double naive_covering(const Labels& map, const Labels& truth) {
    double sum = 0;
    for (std::uint32_t region = 0; region < truth.size(); ++region) {
        double best = 0, area = 0;
        for (std::uint32_t other = 0; other < map.size(); ++other) {
            double both = 0, any = 0;
            area = 0;
            for (std::size_t i = 0; i < truth.size(); ++i) {
                area += truth[i] == region ? 1 : 0;
                both += truth[i] == region && map[i] == other ? 1 : 0;
                any += truth[i] == region || map[i] == other ? 1 : 0;
            }
            if (any > 0) best = std::max(best, both / any);
        }
        sum += area * best;
    }
    return sum / static_cast<double>(truth.size());
}

double naive_rand(const Labels& a, const Labels& b) {
    double agreed = 0, pairs = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            ++pairs;
            agreed += (a[i] == a[j]) == (b[i] == b[j]) ? 1 : 0;
        }
    return agreed / pairs;
}

// The mean over the pixels of what one map leaves unsaid of the other there.
double naive_information(const Labels& a, const Labels& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        double of_a = 0, of_b = 0, of_both = 0;
        for (std::size_t j = 0; j < a.size(); ++j) {
            of_a += a[i] == a[j] ? 1 : 0;
            of_b += b[i] == b[j] ? 1 : 0;
            of_both += a[i] == a[j] && b[i] == b[j] ? 1 : 0;
        }
        sum -= std::log2(of_both / of_a) + std::log2(of_both / of_b);
    }
    return sum / static_cast<double>(a.size());
}

TEST(Regions, AgreeWithNaiveTwins) {
    std::mt19937 random(5);
    for (int i = 0; i < 60; ++i) {
        const std::size_t size = 12 + random() % 30;
        const Labels a = some(random, size, 1 + random() % 9), b = some(random, size, 1 + random() % 9);
        const OverlapTable table = overlaps_of(a, b);
        EXPECT_NEAR(covering(table), naive_covering(a, b), 1e-12) << i;
        EXPECT_NEAR(rand_index(table), naive_rand(a, b), 1e-12) << i;
        EXPECT_NEAR(variation_of_information(table), naive_information(a, b), 1e-9) << i;
    }
}

TEST(Regions, KnownCases) {
    const Labels one(16, 0), halves{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
    Labels each(16);
    for (std::uint32_t i = 0; i < 16; ++i) each[i] = i;
    for (const Labels& map : {one, halves, each}) {
        EXPECT_DOUBLE_EQ(covering(overlaps_of(map, map)), 1);
        EXPECT_DOUBLE_EQ(rand_index(overlaps_of(map, map)), 1);
        EXPECT_DOUBLE_EQ(variation_of_information(overlaps_of(map, map)), 0);
    }
    // One region covers each half by a half; each half covers the one by a half, too.
    EXPECT_DOUBLE_EQ(covering(overlaps_of(one, halves)), 0.5);
    EXPECT_DOUBLE_EQ(covering(overlaps_of(halves, one)), 0.5);
    EXPECT_DOUBLE_EQ(rand_index(overlaps_of(one, halves)), 56.0 / 120);
    EXPECT_DOUBLE_EQ(variation_of_information(overlaps_of(one, halves)), 1);  // one bit: which half
    EXPECT_DOUBLE_EQ(variation_of_information(overlaps_of(each, one)), 4);
    EXPECT_DOUBLE_EQ(covering(overlaps_of(each, one)), 1.0 / 16);
    // Halves across halves: four quarters, no bit in common.
    Labels across(16);
    for (std::uint32_t i = 0; i < 16; ++i) across[i] = i % 2;
    EXPECT_DOUBLE_EQ(variation_of_information(overlaps_of(across, halves)), 2);
    EXPECT_DOUBLE_EQ(covering(overlaps_of(across, halves)), 1.0 / 3);
    EXPECT_THROW(overlaps_of(Labels{0, 7}, Labels{0, 1}), std::logic_error);
    EXPECT_THROW(overlaps_of(one, Labels{0}), std::logic_error);
}

TEST(Regions, LinesLeavePartsAndBelongToTheNearest) {
    // A cross of lines, the upright one three pixels wide.
    PixelSet lines{9, 5, {}};
    for (std::uint32_t y = 0; y < 5; ++y)
        for (std::uint32_t x = 0; x < 9; ++x)
            if (y == 2 || (x > 2 && x < 6)) lines.pixels.push_back(y * 9 + x);
    const LabelMap map = regions_between(lines);
    EXPECT_EQ(map.regions, 4u);
    const Labels want{0, 0, 0, 0, 0, 1, 1, 1, 1,  //
                      0, 0, 0, 0, 0, 1, 1, 1, 1,  //
                      0, 0, 0, 0, 0, 1, 1, 1, 1,  // of two as near, that above and on the left
                      2, 2, 2, 2, 2, 3, 3, 3, 3,  //
                      2, 2, 2, 2, 2, 3, 3, 3, 3};
    EXPECT_EQ(map.label, want);
    EXPECT_EQ(regions_between(PixelSet{3, 2, {}}).regions, 1u);
    EXPECT_EQ(regions_between(PixelSet{2, 1, {0, 1}}).regions, 1u);
}

// A slanting line one pixel wide parts what touches it, though its pixels meet by their corners only.
TEST(Regions, CornersDoNotConnect) {
    PixelSet slant{6, 6, {}};
    for (std::uint32_t i = 0; i < 6; ++i) slant.pixels.push_back(i * 6 + i);
    EXPECT_EQ(regions_between(slant).regions, 2u);
    EXPECT_EQ(connected(Labels{0, 1, 1, 0}, 2, 2).regions, 4u);
    EXPECT_EQ(connected(Labels{5, 5, 9, 5}, 4, 1).label, (Labels{0, 0, 1, 2}));
    EXPECT_THROW(connected(Labels{1}, 2, 2), std::logic_error);
}

TEST(Regions, BordersOfAMapLeaveItAgain) {
    std::mt19937 random(2);
    for (int i = 0; i < 20; ++i) {
        // Three upright bands, the last cut across, each wide enough to keep a pixel beside its border.
        const int first = 3 + static_cast<int>(random() % 10), second = first + 3 + static_cast<int>(random() % 10),
                  row = 3 + static_cast<int>(random() % 10);
        Labels labels;
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 30; ++x) labels.push_back(x < first ? 0u : x < second ? 1u : y < row ? 2u : 3u);
        const LabelMap map = connected(labels, 30, 20);
        EXPECT_EQ(regions_between(borders_of(map)).label, map.label) << i;
        const LabelMap large = resized(map, 90, 60);
        EXPECT_EQ(large.regions, map.regions);
        EXPECT_EQ(resized(large, 30, 20).label, map.label);
    }
    EXPECT_EQ(resized(LabelMap{4, 1, {0, 1, 2, 3}, 4}, 2, 1).label, (Labels{0, 1}));  // numbered anew
}

TEST(Regions, LevelsFallToAll) {
    ASSERT_FALSE(region_levels().empty());
    EXPECT_EQ(region_levels().back(), 0);
    for (std::size_t i = 1; i < region_levels().size(); ++i) EXPECT_LT(region_levels()[i], region_levels()[i - 1]);
}

// Two pictures: one is best cut coarsely, the other finely.
TEST(Regions, OneLevelForAllAndEachItsOwn) {
    const auto coarse = std::make_shared<const LabelMap>(LabelMap{4, 1, {0, 0, 0, 0}, 1});
    const auto fine = std::make_shared<const LabelMap>(LabelMap{4, 1, {0, 0, 1, 1}, 2});
    std::vector<std::shared_ptr<const LabelMap>> maps(region_levels().size(), fine);
    maps[0] = maps[1] = coarse;
    const std::vector<LabelMap> whole{*coarse}, halves{*fine, *fine};
    const std::vector<RegionTrial> trials{score_regions(maps, whole), score_regions(maps, halves), {}};
    ASSERT_EQ(trials[0].curve.size(), maps.size());
    EXPECT_DOUBLE_EQ(trials[0].curve[1].covering, 1);
    EXPECT_DOUBLE_EQ(trials[0].curve[2].covering, 0.5);
    EXPECT_DOUBLE_EQ(trials[1].best, 1);
    const RegionFigures figures = region_figures(trials);
    EXPECT_EQ(figures.pictures, 2u);
    // 4 pixels of one annotator, 8 of two: finely (4 x 1/2 + 8 x 1) / 12.
    EXPECT_DOUBLE_EQ(figures.covering_ods, 10.0 / 12);
    EXPECT_EQ(figures.level, region_levels()[2]);
    EXPECT_DOUBLE_EQ(figures.covering_ois, 1);
    EXPECT_DOUBLE_EQ(figures.covering_best, 1);
    EXPECT_DOUBLE_EQ(figures.information_ods, 0.5);  // each picture once
    EXPECT_DOUBLE_EQ(figures.information_ois, 0);
    EXPECT_DOUBLE_EQ(figures.rand_ods, (1 + 2.0 / 6) / 2);
    EXPECT_DOUBLE_EQ(figures.rand_ois, 1);
    EXPECT_EQ(region_figures({}).pictures, 0u);
}

// A region may take the level that has it best; no single level has both.
TEST(Regions, TheBestTakesRegionsFromAnyLevel) {
    const auto left = std::make_shared<const LabelMap>(LabelMap{6, 1, {0, 0, 1, 1, 2, 3}, 4});
    const auto right = std::make_shared<const LabelMap>(LabelMap{6, 1, {0, 1, 2, 2, 3, 3}, 4});
    std::vector<std::shared_ptr<const LabelMap>> maps(region_levels().size(), left);
    maps.back() = right;
    const std::vector<LabelMap> truth{{6, 1, {0, 0, 1, 1, 2, 2}, 3}};
    const RegionTrial trial = score_regions(maps, truth);
    EXPECT_DOUBLE_EQ(trial.best, 1);
    for (const RegionScore& score : trial.curve) EXPECT_DOUBLE_EQ(score.covering, 5.0 / 6);
    EXPECT_EQ(at_all_levels(truth[0]).size(), region_levels().size());
}

TEST(Regions, PeopleAreScoredAgainstTheOthers) {
    const LabelMap whole{4, 1, {0, 0, 0, 0}, 1}, halves{4, 1, {0, 0, 1, 1}, 2};
    const RegionTrial people = score_people(std::vector<LabelMap>{whole, halves, halves});
    ASSERT_EQ(people.curve.size(), region_levels().size());
    // The whole one: a half, twice. Each of the others: a half and all.
    EXPECT_DOUBLE_EQ(people.curve.front().covering, (0.5 + 0.75 + 0.75) / 3);
    EXPECT_DOUBLE_EQ(people.curve.back().information, (1 + 0.5 + 0.5) / 3);
    EXPECT_DOUBLE_EQ(people.weight, 8);
    EXPECT_TRUE(score_people(std::vector<LabelMap>{whole}).curve.empty());
}

}  // namespace
}  // namespace tactics::regions_test
