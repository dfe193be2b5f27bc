// SPDX-License-Identifier: Apache-2.0
// Distances and the grid against naive twins.
#include "tactics/geometry/distance.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/rules/pages.h"

namespace tactics::distance_test {
namespace {

using namespace tests;

Point on(const Segment& s, double t) { return {s.a.x + t * (s.b.x - s.a.x), s.a.y + t * (s.b.y - s.a.y)}; }

// The least of many samples on both; never less than the truth, and more by at most half a step.
double sampled(const Segment& one, const Segment& other) {
    constexpr int kSteps = 300;
    double least = 1e300;
    for (int i = 0; i <= kSteps; ++i)
        for (int j = 0; j <= kSteps; ++j) least = std::min(least, distance(on(one, i / 300.0), on(other, j / 300.0)));
    return least;
}

TEST(Distance, OfSegmentsIsTheLeastOfManySamples) {
    Dice chance(1);
    int crossed = 0;
    for (int round = 0; round < 200; ++round) {
        const auto point = [&] { return Point{chance.between(0, 10), chance.between(0, 10)}; };
        Segment one{point(), point()}, other{point(), point()};
        if (round % 10 == 0) other = {{one.a.x + 1, one.a.y + 2}, {one.b.x + 1, one.b.y + 2}};  // parallel
        if (round % 10 == 1) other.b = other.a;                                                 // a point
        const Nearest near = nearest(one, other);
        const double most_off = (distance(one.a, one.b) + distance(other.a, other.b)) / 300;
        const double expected = sampled(one, other);
        EXPECT_LE(near.distance, expected + 1e-12);
        EXPECT_GE(near.distance, expected - most_off);
        EXPECT_NEAR(distance(near.one, near.other), near.distance, 1e-12);
        EXPECT_NEAR(distance(near.one, nearest_on(one, near.one)), 0, 1e-9);
        EXPECT_NEAR(distance(near.other, nearest_on(other, near.other)), 0, 1e-9);
        EXPECT_NEAR(nearest(other, one).distance, near.distance, 1e-12);
        crossed += near.distance == 0 ? 1 : 0;
    }
    EXPECT_GT(crossed, 20);
}

TEST(Distance, OfASegmentToABoxIsTheLeastToItsPoints) {
    Dice chance(2);
    for (int round = 0; round < 100; ++round) {
        const Box box{3, 4, 6, 5};
        const Segment line{{chance.between(0, 10), chance.between(0, 10)}, {chance.between(0, 10), chance.between(0, 10)}};
        double least = 1e300;
        for (int i = 0; i <= 300; ++i) {
            const Point p = on(line, i / 300.0);
            least = std::min(least, distance(Box{p.x, p.y, p.x, p.y}, box));
        }
        EXPECT_NEAR(nearest(line, box).distance, least, distance(line.a, line.b) / 300);
    }
}

TEST(Distance, GreatestExtentIsThatOfAllPairs) {
    Dice chance(3);
    for (int round = 0; round < 30; ++round) {
        std::vector<Point> points;
        for (int i = 0; i < 40; ++i) points.push_back({chance.between(0, 10), chance.between(0, 3)});
        double most = 0;
        for (const Point& p : points)
            for (const Point& q : points) most = std::max(most, distance(p, q));
        EXPECT_LE(greatest_extent(points), most + 1e-12);
        EXPECT_GE(greatest_extent(points), most * 0.99996);
    }
}

TEST(Grid, FindsThePairsThatComparingAllFinds) {
    Dice chance(4);
    for (int round = 0; round < 30; ++round) {
        std::vector<Box> boxes;
        for (int i = 0; i < 120; ++i) {
            // Some outside the page, some as large as it.
            const double x = chance.between(-60, 160), y = chance.between(-60, 160);
            const double size = chance.below(20) == 0 ? 150 : 6;
            boxes.push_back({x, y, x + chance.between(0, size), y + chance.between(0, size)});
        }
        if (round == 0) boxes.push_back({-1e300, -1e300, 1e300, 1e300});
        using Pair = std::pair<std::size_t, std::size_t>;
        std::set<Pair> expected;
        for (std::size_t i = 0; i < boxes.size(); ++i)
            for (std::size_t j = i + 1; j < boxes.size(); ++j)
                if (meet(boxes[i], boxes[j])) expected.insert({i, j});
        const Grid grid(boxes, 100, 100);
        std::vector<Pair> got;
        EXPECT_TRUE(grid.pairs(1'000'000, [&](std::size_t i, std::size_t j) {
            got.emplace_back(i, j);
            return true;
        }));
        EXPECT_EQ(std::set<Pair>(got.begin(), got.end()), expected);
        EXPECT_EQ(got.size(), expected.size()) << "a pair came twice";
        std::set<std::size_t> near, all_near;
        const Box window{20, 20, 40, 90};
        grid.any_near(window, [&](std::size_t i) {
            near.insert(i);
            return false;
        });
        for (std::size_t i = 0; i < boxes.size(); ++i)
            if (meet(boxes[i], window)) all_near.insert(i);
        EXPECT_EQ(near, all_near);
        EXPECT_FALSE(grid.pairs(50, [](std::size_t, std::size_t) { return true; })) << "there was to be an end";
    }
}

}  // namespace
}  // namespace tactics::distance_test
