// SPDX-License-Identifier: Apache-2.0
// Of many lines those that a finger can tell apart.
#include "tactics/geometry/apart_lines.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tactics::apart_lines_test {
namespace {

constexpr double kApart = 4, kShortest = 5;

std::vector<Point> places_on(const Stroke& stroke) {
    std::vector<Point> places;
    const std::size_t n = stroke.points.size();
    for (std::size_t i = 0; i < (stroke.closed ? n : n - 1); ++i) {
        const Point a = stroke.points[i], b = stroke.points[(i + 1) % n];
        const int steps = 1 + static_cast<int>(distance(a, b) * 2);
        for (int k = 0; k <= steps; ++k) places.push_back({a.x + (b.x - a.x) * k / steps, a.y + (b.y - a.y) * k / steps});
    }
    return places;
}

double nearest(const Stroke& one, const Stroke& other) {
    double least = 1e9;
    for (const Point& a : places_on(one))
        for (const Point& b : places_on(other)) least = std::min(least, distance(a, b));
    return least;
}

TEST(ApartLines, LinesThatAreFarFromEachOtherStayAsTheyAre) {
    const std::vector<Stroke> lines = {
        {{{0, 0}, {50, 0}}}, {{{0, 10}, {50, 10}, {50, 60}}}, {{{0, 20}, {40, 20}, {20, 50}}, true}};
    EXPECT_EQ(apart_lines(lines, kApart, kShortest).size(), 3u);
}

TEST(ApartLines, OfAHatchingEverySecondOrThirdLineStays) {
    std::vector<Stroke> lines;
    for (int i = 0; i < 30; ++i) lines.push_back({{{0, i * 1.5}, {60, i * 1.5}}});
    const std::vector<Stroke> kept = apart_lines(lines, kApart, kShortest);
    EXPECT_EQ(kept.size(), 10u);
    for (std::size_t i = 0; i < kept.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_GE(nearest(kept[i], kept[j]), kApart);
}

TEST(ApartLines, TheOutlineComesBeforeWhatIsWithin) {
    const Stroke outline{{{0, 0}, {40, 0}, {40, 40}, {0, 40}}, true, LineClass::thick};
    const Stroke within{{{2, 2}, {38, 2}, {38, 38}, {2, 38}}, true, LineClass::thin};
    const std::vector<Stroke> kept = apart_lines({within, outline}, kApart, kShortest);
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept[0].line, LineClass::thick);
    EXPECT_TRUE(kept[0].closed);
}

TEST(ApartLines, LinesMayMeet) {
    const std::vector<Stroke> lines = {{{{0, 0}, {60, 0}}}, {{{30, 0}, {30, 40}}}, {{{0, 0}, {0, 40}}}};
    EXPECT_EQ(apart_lines(lines, kApart, kShortest).size(), 3u);
    for (const Stroke& line : apart_lines(lines, kApart, kShortest))
        EXPECT_GE(length_of(line), 40) << "cut where it meets another";
}

TEST(ApartLines, ALineThatComesTooNearIsCutThere) {
    // From 10 mm off down to 1 mm.
    const std::vector<Stroke> lines = {{{{0, 0}, {100, 0}}, false, LineClass::thick}, {{{0, 10}, {90, 1}}}};
    const std::vector<Stroke> kept = apart_lines(lines, kApart, kShortest);
    ASSERT_EQ(kept.size(), 2u);
    EXPECT_GE(nearest(kept[0], kept[1]), kApart * 0.99);
    EXPECT_NEAR(length_of(kept[1]), 60.3, 1);
}

TEST(ApartLines, WhatIsNarrowIsALineAndWhatIsTinyGoes) {
    const std::vector<Stroke> kept = apart_lines(
        {{{{0, 0}, {40, 0}, {40, 1}, {0, 1}}, true}, {{{0, 20}, {2, 20}, {2, 22}, {0, 22}}, true}}, kApart, kShortest);
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_FALSE(kept[0].closed);
    EXPECT_NEAR(kept[0].points[0].y, 0.5, 1e-9);
    EXPECT_NEAR(length_of(kept[0]), 40, 1e-9);
    EXPECT_TRUE(apart_lines({}, kApart, kShortest).empty());
}

TEST(ApartLines, ALineIsNotNearItself) {
    // A spiral whose turns are 2 mm apart.
    Stroke spiral;
    for (int i = 0; i < 600; ++i) {
        const double angle = i * 0.1, radius = 10 + angle / 3.14159;
        spiral.points.push_back({50 + radius * std::cos(angle), 50 + radius * std::sin(angle)});
    }
    const std::vector<Stroke> kept = apart_lines({spiral}, 3, kShortest);
    ASSERT_FALSE(kept.empty());
    double length = 0;
    for (const Stroke& one : kept) length += length_of(one);
    EXPECT_LT(length, 0.7 * length_of(spiral));
    EXPECT_GT(length, 0.3 * length_of(spiral));
}

}  // namespace
}  // namespace tactics::apart_lines_test
