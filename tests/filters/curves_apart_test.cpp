// SPDX-License-Identifier: Apache-2.0
// Curves that come together: what is left of them is never nearer than the gap, and all that was far enough is still there.
#include "filters/curves_apart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tactics/geometry/course.h"

namespace tactics {
namespace {

constexpr double kGap = 4.5, kLeast = 6.5;
using Line = std::vector<Point>;

double away(Point p, const std::vector<Line>& lines) {
    double least = INFINITY;
    for (const Line& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) least = std::min(least, distance_to_segment(p, line[i - 1], line[i]));
    return least;
}

Line wave(double phase, double high, double middle) {
    Line line;
    for (int i = 0; i <= 400; ++i) line.push_back({i * 0.5, middle + high * std::sin(i * 0.03 + phase)});
    return line;
}

TEST(CurvesApart, KeepTheGapAndLoseNothingElse) {
    std::mt19937 random(3);
    const auto below = [&](int limit) { return static_cast<double>(random() % static_cast<unsigned>(limit)); };
    for (int round = 0; round < 20; ++round) {
        std::vector<Line> curves;
        for (int i = 0; i < 4; ++i) curves.push_back(wave(below(6), 5 + below(40), 40 + below(30)));
        const auto pieces = curves_apart(curves, kGap, kLeast);
        ASSERT_EQ(pieces.size(), curves.size());
        ASSERT_EQ(pieces[0].size(), 1u);
        std::vector<Line> before;
        for (std::size_t i = 0; i < curves.size(); ++i) {
            for (const Line& piece : pieces[i])
                for (const Point& p : piece) {
                    ASSERT_GE(away(p, before), kGap - 0.1);
                    ASSERT_LE(away(p, {curves[i]}), 0.1);
                }
            // What is far from all before it, and so is what lies around it, is drawn.
            for (const Point& p : curves[i])
                if (away(p, before) > kGap + kLeast) {
                    ASSERT_LE(away(p, pieces[i]), 0.1) << round << " " << i;
                }
            for (const Line& piece : pieces[i]) before.push_back(piece);
        }
    }
}

TEST(CurvesApart, ACrossingBreaksTheSecond) {
    const auto pieces = curves_apart({{{0, 50}, {100, 50}}, {{50, 0}, {50, 100}}}, kGap, kLeast);
    ASSERT_EQ(pieces[1].size(), 2u);
    EXPECT_NEAR(pieces[1][0].back().y, 50 - kGap, 0.3);
    EXPECT_NEAR(pieces[1][1].front().y, 50 + kGap, 0.3);
}

TEST(CurvesApart, TwoThatRunTogetherAreOneLine) {
    const Line line = wave(0, 20, 50);
    Line close = line;
    for (Point& p : close) p.y += 1;
    const auto pieces = curves_apart({line, close}, kGap, kLeast);
    EXPECT_TRUE(pieces[1].empty());
    EXPECT_TRUE(curves_apart({}, kGap, kLeast).empty());
    EXPECT_TRUE(curves_apart({{}, {{1, 1}}}, kGap, kLeast)[1].empty());
}

}  // namespace
}  // namespace tactics
