// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "tactics/geometry/evidence.h"
#include "tests/filters/shapes.h"

namespace tactics::separate_test {
namespace {

using shapes::drawn;
using shapes::line;

constexpr double kGap = 3.2;

Drawing sheet(std::vector<Stroke> strokes) { return {100, 100, std::move(strokes), {}, {}}; }

// Every pair of strokes, point by point: nearer than the gap only along the last two gaps of one that ends on the other.
void expect_apart(const Drawing& drawing, double gap) {
    for (std::size_t a = 0; a < drawing.strokes.size(); ++a)
        for (std::size_t b = 0; b < drawing.strokes.size(); ++b) {
            if (a == b) continue;
            const Stroke &one = drawing.strokes[a], &other = drawing.strokes[b];
            const auto ends_on = [gap](const Stroke& stroke, const Stroke& on, Point p) {
                if (stroke.closed) return false;
                for (const Point end : {stroke.points.front(), stroke.points.back()})
                    if (shapes::to_stroke(end, on) <= gap / 2 && std::hypot(p.x - end.x, p.y - end.y) <= 2.2 * gap) return true;
                return false;
            };
            // An end that is led on to a line may come nearer to another.
            const auto is_end = [gap](const Stroke& stroke, Point p) {
                return !stroke.closed &&
                       std::min(distance(p, stroke.points.front()), distance(p, stroke.points.back())) < gap / 3;
            };
            for (const Point& p : shapes::walk(one, 0.2)) {
                if (shapes::to_stroke(p, other) >= (is_end(one, p) ? 0.98 - 1 / 3.0 : 0.98) * gap) continue;
                bool meets = ends_on(one, other, p);
                for (const Point& q : shapes::walk(other, 0.2))
                    if (!meets && std::hypot(q.x - p.x, q.y - p.y) < gap) meets = ends_on(other, one, q);
                EXPECT_TRUE(meets) << a << " and " << b << " at " << p.x << " " << p.y;
                if (!meets) return;
            }
        }
}

TEST(Separate, OfTwoLinesSideBySideTheStrongerStays) {
    const auto drawing = drawn(
        "separate gap=3.2", sheet({line({{10, 20}, {90, 20}}, 5), line({{10, 22}, {90, 22}}, 9), line({{10, 40}, {90, 40}}, 1)}));
    ASSERT_EQ(drawing.strokes.size(), 2u);
    EXPECT_EQ(drawing.strokes[0].strength, 9);
    EXPECT_EQ(drawing.strokes[1].strength, 1);
}

TEST(Separate, CutsOnlyWhatRunsTooNear) {
    // The weaker line comes near, runs along and leaves again.
    const auto drawing =
        drawn("separate gap=3.2", sheet({line({{10, 50}, {90, 50}}, 9), line({{10, 80}, {30, 52}, {60, 52}, {80, 80}}, 5)}));
    ASSERT_EQ(drawing.strokes.size(), 3u);
    EXPECT_NEAR(length_of(drawing.strokes[1]), 32.9, 1);
    EXPECT_NEAR(length_of(drawing.strokes[2]), 32.9, 1);
    expect_apart(drawing, kGap);
}

TEST(Separate, BreaksTheLesserLineAtACrossing) {
    const auto drawing = drawn("separate gap=3.2", sheet({line({{50, 10}, {50, 90}}, 5), line({{10, 50}, {90, 50}}, 9)}));
    ASSERT_EQ(drawing.strokes.size(), 3u);
    EXPECT_NEAR(length_of(drawing.strokes[0]), 80, 1e-9);
    for (int i = 1; i < 3; ++i) EXPECT_NEAR(length_of(drawing.strokes[static_cast<std::size_t>(i)]), 40 - kGap, kGap / 8 + 0.01);
    expect_apart(drawing, kGap);
}

TEST(Separate, LetsALineEndOnAnother) {
    const auto drawing = drawn("separate gap=3.2", sheet({line({{10, 50}, {90, 50}}, 9), line({{50, 50}, {60, 90}}, 5)}));
    ASSERT_EQ(drawing.strokes.size(), 2u);
    EXPECT_LT(shapes::to_stroke(drawing.strokes[1].points.front(), drawing.strokes[0]), 0.01);
    // Less than a line's width off, it touches what is printed, and is led onto it.
    const auto touching = drawn("separate gap=3.2", sheet({line({{10, 50}, {90, 50}}, 9), line({{50, 50.8}, {60, 90}}, 5)}));
    ASSERT_EQ(touching.strokes.size(), 2u);
    EXPECT_EQ(touching.strokes[1].points[0].y, 50);
    EXPECT_EQ(touching.strokes[1].points[1].y, 50.8);
    // One that stops just short of it stops a clear gap short.
    const auto near = drawn("separate gap=3.2", sheet({line({{10, 50}, {90, 50}}, 9), line({{50, 52}, {50, 90}}, 5)}));
    ASSERT_EQ(near.strokes.size(), 2u);
    EXPECT_NEAR(near.strokes[1].points.front().y, 50 + kGap, kGap / 8 + 0.01);
}

// The outline of a bar is stronger than the axis it stands on, and is drawn first.
TEST(Separate, AnAxisGoesOnBelowTheSidesOfBars) {
    const auto drawing =
        drawn("separate gap=3.2", sheet({line({{30, 80}, {30, 40}, {50, 40}, {50, 80}}, 9), line({{10, 80.3}, {90, 80.3}}, 5)}));
    ASSERT_EQ(drawing.strokes.size(), 2u);
    EXPECT_NEAR(length_of(drawing.strokes[1]), 80, 0.1);
    expect_apart(drawing, kGap);
    // A side that does not reach it, or runs on across it, breaks it.
    for (const double foot : {78.0, 84.0}) {
        const auto broken = drawn("separate gap=3.2", sheet({line({{30, 40}, {30, foot}}, 9), line({{10, 80}, {90, 80}}, 1)}));
        EXPECT_GT(broken.strokes.size(), 2u) << foot;
    }
}

// Up one side of a bar, down the other and along the axis, past the foot of the first, and to another bar in the same way.
TEST(Separate, ALineThatBeginsAndEndsOnItselfIsWhole) {
    const auto drawing = drawn(
        "separate gap=3.2", sheet({line({{40, 80}, {40, 40}, {20, 40}, {20, 80}, {80, 80}, {80, 40}, {60, 40}, {60, 80}}, 9)}));
    ASSERT_EQ(drawing.strokes.size(), 1u);
    EXPECT_NEAR(length_of(drawing.strokes[0]), 260, 0.1);
}

// Both axes go on a little beyond each other.
TEST(Separate, AnAxisEndsOnTheOther) {
    const auto drawing = drawn("separate gap=3.2", sheet({line({{20, 10}, {20, 82}}, 9), line({{17, 80}, {90, 80}}, 5)}));
    ASSERT_EQ(drawing.strokes.size(), 2u);
    EXPECT_NEAR(length_of(drawing.strokes[1]), 70, 0.5);
    EXPECT_NEAR(drawing.strokes[1].points.front().x, 20, 0.01);
}

// A whisker is shorter than loose pieces may be.
TEST(Separate, WhatLeadsFromLineToLineMayBeHalfAsLong) {
    const Stroke box = line({{20, 20}, {80, 20}}, 9), cap = line({{40, 25}, {60, 25}}, 9);
    const auto lines_with = [&](double end) {
        return drawn("separate gap=2.5 shortest=9", sheet({box, cap, line({{50, 20}, {50, end}}, 9)})).strokes.size();
    };
    EXPECT_EQ(lines_with(25), 3u);
    EXPECT_EQ(lines_with(28.9), 2u);
    const auto shorter = drawn("separate gap=2.5 shortest=12", sheet({box, cap, line({{50, 20}, {50, 25}}, 9)}));
    EXPECT_EQ(shorter.strokes.size(), 2u);
}

TEST(Separate, MakesOneLineOfTheTwoSidesOfAThinBar) {
    for (const bool closed : {true, false}) {
        const auto drawing =
            drawn("separate gap=3.2", sheet({line({{10, 50}, {40, 50.3}, {90, 51}, {90, 52}, {40, 51.5}, {10, 51}}, 5, closed)}));
        ASSERT_EQ(drawing.strokes.size(), 1u) << closed;
        EXPECT_FALSE(drawing.strokes[0].closed);
        EXPECT_NEAR(length_of(drawing.strokes[0]), 82, 5);
    }
}

TEST(Separate, ADoubleLineIsFollowedFromItsTip) {
    // The outline of the bar begins half way: the line that stays does not change sides there.
    const auto drawing = drawn("separate gap=3.2", sheet({line({{50, 50}, {90, 50}, {90, 51}, {10, 51}, {10, 50}}, 5, true)}));
    ASSERT_EQ(drawing.strokes.size(), 1u);
    EXPECT_NEAR(length_of(drawing.strokes[0]), 82, 5);
}

TEST(Separate, LeavesLoneShapesAlone) {
    std::vector<Point> circle;
    for (int i = 0; i < 60; ++i)
        circle.push_back({50 + 20 * std::cos(i * std::numbers::pi / 30), 50 + 20 * std::sin(i * std::numbers::pi / 30)});
    auto small = circle;
    for (Point& p : small) p = {p.x / 12, p.y / 12};  // 3 mm across: all of it is near itself
    const auto drawing =
        drawn("separate gap=3.2", sheet({line(circle, 5, true), line(small, 5, true), line({{20, 5}, {30, 20}, {40, 5}}, 2)}));
    ASSERT_EQ(drawing.strokes.size(), 3u);
    EXPECT_TRUE(drawing.strokes[0].closed);
    EXPECT_TRUE(drawing.strokes[1].closed);
    EXPECT_NEAR(length_of(drawing.strokes[0]), 2 * std::numbers::pi * 20, 0.2);
    EXPECT_EQ(drawing.strokes[2].points.size(), 3u);
}

TEST(Separate, KeepsTheGapInRandomDrawings) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        std::mt19937 random(seed);
        const auto number = [&](double most) { return static_cast<double>(random() % 10000) * most / 10000; };
        Drawing before = sheet({});
        for (int i = 0; i < 30; ++i) {
            Stroke stroke = line({{number(100), number(100)}}, static_cast<float>(1 + number(50)), i % 5 == 0);
            const double turn = number(0.3) - 0.15;
            double angle = number(6.28);
            for (int k = 0; k < 40; ++k, angle += turn) {
                const Point at = stroke.points.back();
                const auto inside = [](double v) { return v >= 0 && v <= 100; };
                if (!inside(at.x + std::cos(angle)) || !inside(at.y + std::sin(angle))) angle += std::numbers::pi / 2;
                const Point next{at.x + std::cos(angle), at.y + std::sin(angle)};
                if (inside(next.x) && inside(next.y)) stroke.points.push_back(next);
            }
            before.strokes.push_back(stroke);
        }
        for (const auto& [gap, shortest] : {std::pair{3.2, 6.4}, {6.0, 3.0}}) {
            SCOPED_TRACE(testing::Message() << seed << ", gap " << gap);
            const auto after = drawn("separate gap=" + std::to_string(gap) + " shortest=" + std::to_string(shortest), before);
            EXPECT_LT(total_stroke_length(after), total_stroke_length(before));
            expect_apart(after, gap);
            for (const Stroke& stroke : after.strokes) {
                EXPECT_GE(length_of(stroke), shortest);
                // Nothing is drawn where nothing was but for an end that is led onto the line it touches.
                for (const Point& p : shapes::walk(stroke, 1)) {
                    double least = 1e9;
                    for (const Stroke& old : before.strokes) least = std::min(least, shapes::to_stroke(p, old));
                    const bool at_end = std::min(distance(p, stroke.points.front()), distance(p, stroke.points.back())) < gap / 3;
                    EXPECT_LT(least, at_end ? gap / 3 : 1e-6);
                }
                if (stroke.closed) continue;
                // So an end is on a line or clearly away from it, but for another's end, which may have been led past it.
                for (const Point& end : {stroke.points.front(), stroke.points.back()})
                    for (const Stroke& other : after.strokes) {
                        const double away = &other == &stroke ? 1e9 : shapes::to_stroke(end, other);
                        const double ends = std::min(distance(end, other.points.front()), distance(end, other.points.back()));
                        EXPECT_TRUE(away < 1e-3 || away > gap / 6 || (!other.closed && ends < gap)) << away;
                    }
            }
            // Once apart, nothing more happens.
            const auto again =
                drawn("separate gap=" + std::to_string(gap * 0.97) + " shortest=" + std::to_string(shortest), after);
            EXPECT_NEAR(total_stroke_length(again), total_stroke_length(after), 0.05 * total_stroke_length(after));
        }
    }
}

}  // namespace
}  // namespace tactics::separate_test
