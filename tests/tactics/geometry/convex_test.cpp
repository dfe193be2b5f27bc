// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/convex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tactics/geometry/vectors.h"

namespace tactics::convex_test {
namespace {

class Chance {
public:
    explicit Chance(unsigned seed) : engine_(seed) {}
    double next() { return static_cast<double>(engine_()) / 4294967295.0; }
    std::vector<Point> points(int count, double size) {
        std::vector<Point> made;
        const Point off{size * next(), size * next()};
        for (int i = 0; i < count; ++i) made.push_back({off.x + size * next(), off.y + size * next()});
        return made;
    }

private:
    std::mt19937 engine_;
};

// On the inside of every side.
bool is_in(const Convex& one, Point at) {
    for (std::size_t i = 0; i < one.size(); ++i)
        if (cross(one[(i + 1) % one.size()] - one[i], at - one[i]) < -1e-9) return false;
    return true;
}

TEST(Convex, AHullHoldsAllItsPointsAndTurnsOneWay) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        Chance chance(seed);
        const std::vector<Point> points = chance.points(3 + static_cast<int>(seed), 10);
        const Convex hull = hull_of(points);
        ASSERT_GE(hull.size(), 3u);
        for (const Point& at : points) EXPECT_TRUE(is_in(hull, at)) << seed;
        for (std::size_t i = 0; i < hull.size(); ++i) {
            EXPECT_GT(cross(hull[(i + 1) % hull.size()] - hull[i], hull[(i + 2) % hull.size()] - hull[i]), 0) << seed;
            EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](Point p) { return distance(p, hull[i]) == 0; }));
        }
    }
    EXPECT_EQ(hull_of({{1, 1}, {1, 1}, {1, 1}}).size(), 1u);
    EXPECT_EQ(hull_of({{0, 0}, {2, 2}, {1, 1}}).size(), 2u);
    EXPECT_TRUE(hull_of({}).empty());
}

// By darts thrown at both.
TEST(Convex, WhatTwoHaveInCommonIsInBoth) {
    int shared = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Chance chance(seed);
        const Convex one = hull_of(chance.points(8, 10)), other = hull_of(chance.points(8, 10));
        const Convex both = common_part(one, other);
        constexpr int kDarts = 20'000;
        int hits = 0;
        for (int i = 0; i < kDarts; ++i) {
            const Point at{20 * chance.next(), 20 * chance.next()};
            hits += is_in(one, at) && is_in(other, at);
        }
        EXPECT_NEAR(area_of(both), 400.0 * hits / kDarts, 3) << seed;
        EXPECT_NEAR(area_of(both), area_of(common_part(other, one)), 1e-9);
        shared += hits > 0;
    }
    EXPECT_GT(shared, 10);
}

TEST(Convex, TwoThatAreMovedByWhatPartsThemTouch) {
    int apart = 0, over = 0;
    for (unsigned seed = 1; seed <= 200; ++seed) {
        Chance chance(seed);
        const Convex one = hull_of(chance.points(6, 10)), other = hull_of(chance.points(6, 10));
        const Parting parting = parting_of(one, other);
        EXPECT_NEAR(std::hypot(parting.way.x, parting.way.y), 1, 1e-9);
        (parting.room > 0 ? apart : over) += 1;
        Convex moved = other;
        for (Point& at : moved) at = {at.x - parting.room * parting.way.x, at.y - parting.room * parting.way.y};
        EXPECT_LT(area_of(common_part(one, moved)), 1e-6) << seed;
        // Touching: a little farther and they overlap.
        if (parting.room > 0) {
            for (Point& at : moved) at = {at.x - 0.01 * parting.way.x, at.y - 0.01 * parting.way.y};
            EXPECT_LT(parting_of(one, moved).room, 0) << seed;
        }
    }
    EXPECT_GT(apart, 20);
    EXPECT_GT(over, 20);
    const Convex square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, corner = {{4, 5}, {5, 5}, {5, 6}, {4, 6}};
    EXPECT_NEAR(parting_of(square, corner).room, 5, 1e-9);
    EXPECT_NEAR(parting_of(square, corner, {1, 0}).room, 3, 1e-9);
}

}  // namespace
}  // namespace tactics::convex_test
