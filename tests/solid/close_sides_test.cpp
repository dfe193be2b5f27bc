// SPDX-License-Identifier: Apache-2.0
// Narrow strips become lines, and nothing else changes.
#include "tactics/solid/close_sides.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tactics/geometry/course.h"

namespace tactics::close_sides_test {
namespace {

constexpr double kTouching = 1e-3, kApart = 3;

DrawnSide side(Point from, Point to) { return {from, to, LineClass::normal, false}; }

void add_box(std::vector<DrawnSide>& sides, double left, double top, double right, double bottom) {
    sides.push_back(side({left, top}, {right, top}));
    sides.push_back(side({right, top}, {right, bottom}));
    sides.push_back(side({right, bottom}, {left, bottom}));
    sides.push_back(side({left, bottom}, {left, top}));
}

bool meets_another(const std::vector<DrawnSide>& sides, std::size_t number, Point end) {
    for (std::size_t i = 0; i < sides.size(); ++i)
        if (i != number && distance(nearest_on_segment(end, sides[i].from, sides[i].to), end) < 5 * kTouching) return true;
    return false;
}

// Of upright lines that run beside each other for long, the least distance.
double least_distance(const std::vector<DrawnSide>& sides) {
    double least = 1e9;
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t j = i + 1; j < sides.size(); ++j) {
            const DrawnSide &a = sides[i], &b = sides[j];
            if (std::abs(a.from.x - a.to.x) > kTouching || std::abs(b.from.x - b.to.x) > kTouching) continue;
            const double overlap = std::min(std::max(a.from.y, a.to.y), std::max(b.from.y, b.to.y)) -
                                   std::max(std::min(a.from.y, a.to.y), std::min(b.from.y, b.to.y));
            if (overlap >= 3 * kApart) least = std::min(least, std::abs(a.from.x - b.from.x));
        }
    return least;
}

TEST(CloseSides, OfANarrowStripAreOneAndWhatIsBesideItIsWhole) {
    std::vector<DrawnSide> sides;
    add_box(sides, 0, 0, 60, 40);
    add_box(sides, 60, 0, 62, 40);
    add_box(sides, 62, 0, 90, 40);
    sides = merged(sides, kTouching);
    EXPECT_EQ(unite_close(sides, kTouching, kApart), 1u);
    EXPECT_GE(least_distance(sides), kApart);
    EXPECT_EQ(sides.size(), 5u);  // two long ones across, three upright
    for (std::size_t i = 0; i < sides.size(); ++i) {
        EXPECT_TRUE(meets_another(sides, i, sides[i].from)) << i;
        EXPECT_TRUE(meets_another(sides, i, sides[i].to)) << i;
    }
}

TEST(CloseSides, StayWhereTheyAreFarOrShort) {
    std::vector<DrawnSide> sides;
    add_box(sides, 0, 0, 3.1, 40);
    add_box(sides, 50, 0, 52, 8);
    sides = merged(sides, kTouching);
    const std::vector<DrawnSide> before = sides;
    EXPECT_EQ(unite_close(sides, kTouching, kApart), 0u);
    ASSERT_EQ(sides.size(), before.size());
    for (std::size_t i = 0; i < sides.size(); ++i) {
        EXPECT_EQ(distance(sides[i].from, before[i].from), 0);
        EXPECT_EQ(distance(sides[i].to, before[i].to), 0);
    }
}

// A line that goes on beyond the strip moves as a whole: it has no kink.
TEST(CloseSides, StayStraight) {
    std::vector<DrawnSide> sides = {side({0, 0}, {0, 60}), side({2, 10}, {2, 30}), side({2, 30}, {2, 50}),
                                    side({2, 30}, {20, 30})};
    EXPECT_EQ(unite_close(sides, kTouching, kApart), 1u);
    ASSERT_EQ(sides.size(), 2u);
    EXPECT_NEAR(std::min(sides[0].from.x, sides[0].to.x), 0, 1e-9);
    EXPECT_NEAR(sides[0].from.y, 30, 1e-9);
}

TEST(CloseSides, OfManyBoxesInARowKeepTheirDistanceAndTheirConnections) {
    std::mt19937 random(5);
    for (int scene = 0; scene < 200; ++scene) {
        std::uniform_real_distribution<double> wide(0.5, 12);
        std::vector<DrawnSide> sides;
        double x = 0;
        for (int i = 0; i < 8; ++i) {
            const double next = x + wide(random);
            add_box(sides, x, 0, next, 40);
            x = next;
        }
        sides = merged(sides, kTouching);
        unite_close(sides, kTouching, kApart);
        EXPECT_GE(least_distance(sides), kApart) << scene;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            EXPECT_TRUE(meets_another(sides, i, sides[i].from)) << scene;
            EXPECT_TRUE(meets_another(sides, i, sides[i].to)) << scene;
            EXPECT_TRUE(std::abs(sides[i].from.x - sides[i].to.x) < 1e-9 || std::abs(sides[i].from.y - sides[i].to.y) < 1e-9);
        }
    }
}

// A board before a strip: if its own two edges became one on the side of the strip, the strip would be lost, too.
TEST(CloseSides, OfTwoAsLongTheOneMovesThatOthersAreCloseTo) {
    for (const bool turned : {false, true})
        for (const double noise : {-1e-9, 0.0, 1e-9}) {
            std::vector<DrawnSide> sides = {side({60, 0}, {60, 40}), side({62, 0}, {62, 40 + noise}),
                                            side({63.2, 0}, {63.2, 40})};
            if (turned) std::reverse(sides.begin(), sides.end());
            EXPECT_EQ(unite_close(sides, kTouching, kApart), 1u);
            ASSERT_EQ(sides.size(), 2u);
            EXPECT_NEAR(least_distance(sides), 3.2, 0.01);
        }
}

// It begins on the other, or before it by the last digit of a file.
TEST(CloseSides, AWedgeIsTheSameWhereverItsTipEnds) {
    for (const double noise : {-1e-9, 0.0, 1e-9}) {
        std::vector<DrawnSide> sides = {side({0, 0}, {60, 0}), side({0, noise}, {60, 1.5})};
        EXPECT_EQ(unite_close(sides, kTouching, kApart), 1u) << noise;
    }
}

}  // namespace
}  // namespace tactics::close_sides_test
