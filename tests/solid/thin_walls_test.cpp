// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/thin_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tactics/geometry/course.h"

namespace tactics::thin_walls_test {
namespace {

double length_of(const std::vector<LaidLine>& lines) {
    double sum = 0;
    for (const LaidLine& line : lines)
        for (std::size_t i = 0; i + (line.closed ? 0 : 1) < line.points.size(); ++i)
            sum += distance(line.points[i], line.points[(i + 1) % line.points.size()]);
    return sum;
}

// A cup cut through, from the middle of its outer bottom to that of its inner one, and what it looks like from outside.
std::vector<LaidLine> half_a_cup(double wall) {
    return {{{{0, 0}, {30, 0}, {40, 90}, {40 - wall, 90}, {30 - wall, wall}, {0, wall}}, false}};
}
const std::vector<std::vector<Point>> kOutline = {{{-30, 0}, {30, 0}, {40, 90}, {-40, 90}}};

TEST(ThinWalls, ASlantedWallOfTwoLinesBecomesItsOuterOne) {
    std::vector<LaidLine> lines = half_a_cup(1);
    EXPECT_EQ(leave_out_inner(lines, kOutline, 0.01, 2.5), 1u);
    const double outer = 30 + std::hypot(10, 90);
    EXPECT_NEAR(length_of(lines), outer, 3);
    // Nothing that is left is too close to the outer side, but for what is on it.
    for (const LaidLine& line : lines)
        for (const Point& at : line.points)
            EXPECT_LT(std::min(distance_to_segment(at, {0, 0}, {30, 0}), distance_to_segment(at, {30, 0}, {40, 90})), 2.5);
}

TEST(ThinWalls, AThickWallKeepsBothLines) {
    std::vector<LaidLine> lines = half_a_cup(6);
    const double before = length_of(lines);
    EXPECT_EQ(leave_out_inner(lines, kOutline, 0.01, 2.5), 0u);
    EXPECT_NEAR(length_of(lines), before, 1e-9);
}

// Where a wall grows thick, its inner line begins on the outer one.
TEST(ThinWalls, AnInnerLineIsJoinedWhereItBegins) {
    std::vector<LaidLine> lines = {{{{0, 0}, {100, 0}, {100, 20}, {0, 1}}, false}};
    EXPECT_EQ(leave_out_inner(lines, {{{0, 0}, {100, 0}, {100, 20}, {0, 20}}}, 0.01, 5), 1u);
    ASSERT_FALSE(lines.empty());
    const std::vector<Point>& last = lines.back().points;
    EXPECT_LT(std::abs(last.back().y), 1e-9);
    EXPECT_NEAR(last.back().x, 20, 5);
}

TEST(ThinWalls, ACircleCloseToABorderGoesAndOneFartherInStays) {
    const auto circle = [](double radius) {
        LaidLine line{{}, true};
        for (int i = 0; i < 48; ++i) line.points.push_back({radius * std::cos(0.1309 * i), radius * std::sin(0.1309 * i)});
        return line;
    };
    for (const double radius : {19.0, 12.0}) {
        std::vector<LaidLine> lines = {circle(radius), circle(20)};
        leave_out_inner(lines, {circle(20).points}, 0.01, 2.5);
        EXPECT_EQ(lines.size(), radius > 17 ? 1u : 2u);
    }
}

}  // namespace
}  // namespace tactics::thin_walls_test
