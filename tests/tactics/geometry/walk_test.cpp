// SPDX-License-Identifier: Apache-2.0
#include "tactics/geometry/walk.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tactics/geometry/course.h"

namespace tactics::walk_test {
namespace {

std::vector<Point> wiggle(std::mt19937& random, std::size_t count) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back({static_cast<double>(random() % 1000) / 10, static_cast<double>(random() % 1000) / 10});
    return points;
}

// The same by looking from the beginning every time.
Point place_on(const std::vector<Point>& points, bool closed, double along) {
    const std::size_t sides = points.size() - (closed ? 0 : 1);
    for (std::size_t i = 0; i < sides; ++i) {
        const Point a = points[i], b = points[(i + 1) % points.size()];
        const double side = distance(a, b);
        if (along < side) return {a.x + along / side * (b.x - a.x), a.y + along / side * (b.y - a.y)};
        along -= side;
    }
    return closed ? points.front() : points.back();
}

TEST(Walk, ComesToThePlacesThatLookingFromTheBeginningFinds) {
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        std::vector<Point> points = wiggle(random, 2 + random() % 30);
        points.push_back(points.back());  // a side of no length
        const bool closed = round % 2 == 0;
        Walk walk(points, closed);
        const double length = length_of(Stroke{points, closed});
        for (double along = 0; along < length + 3; along += 0.7) {
            const Point found = walk.to(along), naive = place_on(points, closed, along);
            ASSERT_LT(distance(found, naive), 1e-6) << along << " of " << length;
        }
    }
}

TEST(Walk, EvenStepsOfAStraightLineAreEven) {
    const std::vector<Point> line = {{1, 1}, {2, 1}, {2, 1}, {7, 1}, {11, 1}};
    Walk walk(line, false);
    for (int i = 0; i <= 40; ++i) {
        const Point p = walk.to(0.25 * i);
        EXPECT_NEAR(p.x, 1 + 0.25 * i, 1e-12);
        EXPECT_EQ(p.y, 1);
    }
}

TEST(Walk, OnePointIsAWalkToo) {
    const std::vector<Point> point = {{3, 4}};
    Walk open(point, false), closed(point, true);
    EXPECT_EQ(open.to(0).x, 3);
    EXPECT_EQ(open.to(5).y, 4);
    EXPECT_EQ(closed.to(5).y, 4);
}

}  // namespace
}  // namespace tactics::walk_test
