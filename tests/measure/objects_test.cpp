// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/objects.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace tactics::objects_test {
namespace {

constexpr int kWidth = 60, kHeight = 40;

// A ground with rectangles on it: left, top, right, bottom.
LabelMap ground_with(const std::vector<std::array<int, 4>>& things) {
    std::vector<std::uint32_t> labels(static_cast<std::size_t>(kWidth) * kHeight, 0);
    for (std::size_t i = 0; i < things.size(); ++i)
        for (int y = things[i][1]; y < things[i][3]; ++y)
            for (int x = things[i][0]; x < things[i][2]; ++x)
                labels[static_cast<std::size_t>(y * kWidth + x)] = static_cast<std::uint32_t>(i + 1);
    return connected(labels, kWidth, kHeight);
}

TEST(Objects, AreWhatThreeAgreeOn) {
    // All three have the first, a little apart; two the second; the third thing is one person's alone.
    const std::vector<LabelMap> people{ground_with({{10, 10, 20, 30}, {30, 10, 40, 30}}),
                                       ground_with({{10, 10, 20, 31}, {30, 10, 40, 30}}),
                                       ground_with({{10, 11, 20, 30}, {44, 2, 58, 38}})};
    const auto objects = agreed_objects(people);
    ASSERT_EQ(objects.size(), 1u);  // the ground touches all four sides
    EXPECT_EQ(objects[0].people, 3);
    EXPECT_EQ(objects[0].box, (std::array<int, 4>{10, 10, 20, 30}));  // what two of the three have
    EXPECT_DOUBLE_EQ(objects[0].share, 200.0 / (kWidth * kHeight));
    EXPECT_EQ(overlap_of(objects[0].mask, region_at(people[0], {15, 20})), 1);
    // Deep inside: 5 pixels from either side.
    EXPECT_TRUE(objects[0].inside[0] == 14 || objects[0].inside[0] == 15) << objects[0].inside[0];
    EXPECT_GE(objects[0].inside[1], 14);
    EXPECT_LE(objects[0].inside[1], 25);
}

TEST(Objects, TooSmallTooLargeOrTooUnlikeAreNone) {
    const LabelMap small = ground_with({{10, 10, 16, 17}});  // 42 of 2400 pixels
    EXPECT_TRUE(agreed_objects(std::vector<LabelMap>{small, small, small}).empty());
    const LabelMap large = ground_with({{0, 0, 40, 40}});  // two thirds, and the third that it leaves
    const auto rest = agreed_objects(std::vector<LabelMap>{large, large, large});
    ASSERT_EQ(rest.size(), 1u);
    EXPECT_EQ(rest[0].box, (std::array<int, 4>{40, 0, 60, 40}));
    EXPECT_NEAR(rest[0].inside[0], 49.5, 0.5);              // as far from the frame as from the other side
    const LabelMap middle = ground_with({{7, 4, 53, 36}});  // 61 %; the ground around it is small enough, but its box is all
    EXPECT_TRUE(agreed_objects(std::vector<LabelMap>{middle, middle, middle}).empty());
    // 10 x 20 against 7 x 20 is just alike, against 6 x 20 not.
    const auto with = [](int right) { return ground_with({{10, 10, right, 30}}); };
    EXPECT_EQ(agreed_objects(std::vector<LabelMap>{with(20), with(17), with(20)}).size(), 1u);
    EXPECT_EQ(agreed_objects(std::vector<LabelMap>{with(20), with(16), with(20)}).size(), 0u);
    EXPECT_TRUE(agreed_objects(std::vector<LabelMap>{with(20), with(20)}).empty());
    EXPECT_TRUE(agreed_objects({}).empty());
}

TEST(Objects, WhatMostPeopleHaveComesFirst) {
    const auto both = ground_with({{2, 2, 22, 38}, {40, 10, 50, 30}}), one = ground_with({{40, 10, 50, 30}});
    const auto objects = agreed_objects(std::vector<LabelMap>{both, both, both, one});
    ASSERT_EQ(objects.size(), 2u);
    EXPECT_EQ(objects[0].people, 4);
    EXPECT_EQ(objects[1].people, 3);
}

TEST(Objects, OverlapIsIntersectionOverUnion) {
    const std::vector<std::uint8_t> a{1, 1, 1, 0}, b{0, 1, 1, 1}, none(4, 0);
    EXPECT_DOUBLE_EQ(overlap_of(a, b), 0.5);
    EXPECT_DOUBLE_EQ(overlap_of(a, a), 1);
    EXPECT_DOUBLE_EQ(overlap_of(a, none), 0);
    EXPECT_DOUBLE_EQ(overlap_of(none, none), 0);
    EXPECT_THROW(overlap_of(a, std::vector<std::uint8_t>{1}), std::logic_error);
}

TEST(Objects, RegionsOfABoxAreThoseMostlyInIt) {
    const LabelMap map = ground_with({{10, 10, 20, 30}, {30, 10, 40, 30}});
    const auto within = regions_in(map, {8, 8, 35, 32});  // the second by half only
    EXPECT_EQ(within, region_at(map, {15, 20}));
    EXPECT_NE(regions_in(map, {8, 8, 36, 32}), within);
}

}  // namespace
}  // namespace tactics::objects_test
