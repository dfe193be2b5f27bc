// SPDX-License-Identifier: Apache-2.0
// Curves that come together: what is left of them is never nearer than the gap, and all that was far enough is still there.
#include "filters/curves_apart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tactics/geometry/course.h"

namespace tactics::curves_apart_test {
namespace {

constexpr double kGap = 4.5, kLeast = 6.5;
using Line = std::vector<Point>;

constexpr double kWidth = 1;

// Whole lines of that width with the gap between them, middle to middle kGap.
std::vector<std::vector<Line>> apart(const std::vector<Line>& lines) {
    std::vector<ApartCurve> curves;
    for (const Line& line : lines) curves.push_back({{line}, kWidth});
    return curves_apart(curves, {kGap - kWidth, kLeast, 0, {}});
}

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
        const auto pieces = apart(curves);
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
    const auto pieces = apart({{{0, 50}, {100, 50}}, {{50, 0}, {50, 100}}});
    ASSERT_EQ(pieces[1].size(), 2u);
    EXPECT_NEAR(pieces[1][0].back().y, 50 - kGap, 0.3);
    EXPECT_NEAR(pieces[1][1].front().y, 50 + kGap, 0.3);
}

TEST(CurvesApart, TwoThatRunTogetherAreOneLine) {
    const Line line = wave(0, 20, 50);
    Line close = line;
    for (Point& p : close) p.y += 1;
    const auto pieces = apart({line, close});
    EXPECT_TRUE(pieces[1].empty());
    EXPECT_TRUE(apart({}).empty());
    EXPECT_TRUE(apart({{}, {{1, 1}}})[1].empty());
}

TEST(CurvesApart, ASpikeTooSharpIsBrokenBehindItsTip) {
    const auto pieces = apart({{{0, 100}, {50, 0}, {100, 100}}, {}});
    EXPECT_EQ(pieces[0].size(), 1u) << "a finger finds the way around this corner";
    const auto sharp = apart({{{0, 100}, {4, 0}, {8, 100}}})[0];
    ASSERT_EQ(sharp.size(), 2u);
    EXPECT_LE(away({4, 0}, {sharp[0]}), 0.1) << "the tip is there";
    for (const Point& p : sharp[1]) EXPECT_GE(away(p, {sharp[0]}), kGap - 0.1);
}

TEST(CurvesApart, AClosedLineStaysClosedOrIsCutWhereItMust) {
    Line ring;
    for (int i = 0; i <= 60; ++i) ring.push_back({50 + 30 * std::cos(i * 0.10472), 50 + 30 * std::sin(i * 0.10472)});
    ring.back() = ring.front();
    const auto whole = apart({ring})[0];
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_EQ(distance(whole[0].front(), whole[0].back()), 0);
    // Cut on the left, it is one piece through where it began on the right.
    const auto cut = apart({{{20, 0}, {20, 100}}, ring});
    ASSERT_EQ(cut[1].size(), 1u);
    EXPECT_GT(distance(cut[1][0].front(), cut[1][0].back()), kGap);
    Line small = ring;
    for (Point& p : small) p = {50 + (p.x - 50) / 20, 50 + (p.y - 50) / 20};
    EXPECT_TRUE(apart({small})[0].empty()) << "it would be felt as a dot";
}

TEST(CurvesApart, WiderLinesAreFartherApart) {
    const std::vector<ApartCurve> curves{{{{{0, 50}, {100, 50}}}, 3}, {{{{50, 0}, {50, 100}}}, 1}};
    const auto pieces = curves_apart(curves, {3.2, kLeast, 0, {}});
    ASSERT_EQ(pieces[1].size(), 2u);
    EXPECT_NEAR(pieces[1][0].back().y, 50 - 5.2, 0.4);
    const auto blocked =
        curves_apart(curves, {3.2, kLeast, 0, [](std::size_t curve, Point p) { return curve == 0 && p.x < 30; }});
    ASSERT_EQ(blocked[0].size(), 1u);
    EXPECT_GE(blocked[0][0].front().x, 30);
}

}  // namespace
}  // namespace tactics::curves_apart_test
