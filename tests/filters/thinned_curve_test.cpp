// SPDX-License-Identifier: Apache-2.0
#include "filters/thinned_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace tactics {
namespace {

double noise(std::mt19937& random) { return static_cast<double>(random() % 100'000) / 1000; }

// As the paper has it: of all points of a column the first, the last, the lowest and the highest, by a query for each.
std::vector<Point> by_queries(const std::vector<Point>& points, double width) {
    std::map<double, std::vector<std::size_t>> columns;
    for (std::size_t i = 0; i < points.size(); ++i) columns[std::floor(points[i].x / width)].push_back(i);
    std::vector<bool> stays(points.size());
    for (const auto& [column, of] : columns) {
        const auto lower = [&](std::size_t a, std::size_t b) { return points[a].y < points[b].y; };
        stays[of.front()] = stays[of.back()] = true;
        stays[*std::min_element(of.begin(), of.end(), lower)] = true;
        // The first of the highest.
        stays[*std::min_element(of.begin(), of.end(), [&](auto a, auto b) { return points[a].y > points[b].y; })] = true;
    }
    std::vector<Point> kept;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (stays[i]) kept.push_back(points[i]);
    return kept;
}

bool same(const std::vector<Point>& a, const std::vector<Point>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; });
}

TEST(ThinnedCurve, KeepsFirstLowestHighestAndLastOfEachColumn) {
    std::mt19937 random(3);
    for (int round = 0; round < 50; ++round) {
        std::vector<Point> curve;
        const int count = 1 + static_cast<int>(random() % 5000);
        for (int i = 0; i < count; ++i) curve.push_back({-20 + i * 0.01, std::round(noise(random))});
        EXPECT_TRUE(same(thinned_curve(curve, 0.1), by_queries(curve, 0.1))) << round;
    }
}

// The ink: in each column the same reach from low to high, and the same way from one column to the next.
TEST(ThinnedCurve, ReachesAsHighAndAsLowEverywhere) {
    std::mt19937 random(5);
    std::vector<Point> curve;
    for (int i = 0; i < 300'000; ++i) curve.push_back({i * 150.0 / 300'000, noise(random)});
    const auto thin = thinned_curve(curve, 0.1);
    EXPECT_LE(thin.size(), 4u * 1500);
    struct Reach {
        double low = 1e9, high = -1e9;
    };
    const auto reaches = [](const std::vector<Point>& points) {
        std::map<double, Reach> all;
        for (const Point& point : points) {
            Reach& reach = all[std::floor(point.x / 0.1)];
            reach.low = std::min(reach.low, point.y);
            reach.high = std::max(reach.high, point.y);
        }
        return all;
    };
    const auto whole = reaches(curve), few = reaches(thin);
    ASSERT_EQ(whole.size(), few.size());
    for (const auto& [column, reach] : whole) {
        EXPECT_EQ(reach.low, few.at(column).low);
        EXPECT_EQ(reach.high, few.at(column).high);
    }
    EXPECT_TRUE(same(thinned_curve(thin, 0.1), thin)) << "a second time changes nothing";
}

TEST(ThinnedCurve, LeavesAloneWhatIsNotCrowded) {
    EXPECT_TRUE(thinned_curve({}, 0.1).empty());
    const std::vector<Point> few = {{0, 0}, {10, 5}, {5, 7}, {5, -7}, {5, 3}, {0, 0}};
    EXPECT_TRUE(same(thinned_curve(few, 0.1), few)) << "to and fro, and upright";
    const std::vector<Point> upright = {{1, 0}, {1, 9}, {1, 3}, {1, 4}, {1, -2}, {1, 5}};
    EXPECT_TRUE(same(thinned_curve(upright, 0.1), {{1, 0}, {1, 9}, {1, -2}, {1, 5}}));
    EXPECT_EQ(thinned_curve(std::vector<Point>(1000, Point{2, 3}), 0.1).size(), 2u) << "its first and its last";
}

}  // namespace
}  // namespace tactics
