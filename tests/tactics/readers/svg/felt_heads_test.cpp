// SPDX-License-Identifier: Apache-2.0
// Heads of arrows that a finger finds, and small shapes that are none.
#include "tactics/readers/svg/felt_heads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tactics/geometry/box.h"

namespace tactics::felt_heads_test {
namespace {

// A line to the right that ends at (100, 50), and a box before it.
Drawing arrow(double length, double gap) {
    Drawing drawing{200, 100, {}, {}, {}};
    drawing.strokes.push_back({{{100 - length, 50}, {100, 50}}, false});
    drawing.strokes.push_back({{{100 + gap, 40}, {120, 40}, {120, 60}, {100 + gap, 60}}, true});
    return drawing;
}

double height_of(const std::vector<Point>& points) { return box_of(points).height(); }

TEST(FeltHeads, OfSpecksAreLargeEnough) {
    for (const std::vector<Point>& ring :
         {std::vector<Point>{{98.5, 49.5}, {100, 50}, {98.5, 50.5}},
          std::vector<Point>{{98.5, 49.5}, {100, 50}, {98.5, 50.5}, {99, 50}},
          // As graphviz has it: to the end of the line and back, and the tip twice.
          std::vector<Point>{{100, 50}, {98.5, 49.5}, {99, 50}, {98.5, 50}, {98.5, 50}, {99, 50}, {98.5, 50.5}, {100, 50}}}) {
        Drawing drawing = arrow(30, 10);
        drawing.areas.push_back({{ring}});
        drawing.strokes.push_back({ring, true});  // its rim
        make_heads_felt(drawing);
        EXPECT_TRUE(drawing.areas.empty()) << "a filled one is felt as a blob";
        ASSERT_EQ(drawing.strokes.size(), 3u) << "the rim would make it blunt";
        const Stroke& head = drawing.strokes[2];
        EXPECT_EQ(head.role, Role::arrow);
        EXPECT_GT(head.strength, 0) << "other lines yield to it";
        EXPECT_FALSE(head.closed);
        ASSERT_EQ(head.points.size(), 3u);
        EXPECT_NEAR(head.points[1].x, 100, 1e-9);
        EXPECT_NEAR(distance(head.points[0], head.points[1]), 6.4, 0.2);
        EXPECT_GE(height_of(head.points), 2 * 3.2) << "its sides end a gap from its line";
    }
}

// The line of a filled head ends at its back.
TEST(FeltHeads, AreReachedByTheirLine) {
    Drawing drawing = arrow(30, 10);
    drawing.strokes[0].points[1] = {96, 50};
    drawing.areas.push_back({{{{96, 48}, {100, 50}, {96, 52}}}});
    make_heads_felt(drawing);
    EXPECT_NEAR(distance(drawing.strokes[0].points[1], {100, 50}), 0, 1e-9);
}

TEST(FeltHeads, OfOpenSidesPointTheSameWay) {
    Drawing drawing = arrow(30, 10);
    drawing.strokes.push_back({{{98, 49}, {100, 50}, {98, 51}}, false});
    make_heads_felt(drawing);
    const Stroke& head = drawing.strokes[2];
    EXPECT_EQ(head.role, Role::arrow);
    EXPECT_NEAR(distance(head.points[0], head.points[1]), 6.4, 0.2);
    EXPECT_LT(head.points[0].x, 100);
    EXPECT_NEAR(distance(head.points[1], {100, 50}), 0, 1e-9);
}

// As TeX draws them, both sides bowed towards the line; an arc over the end of a line is bowed the other way.
TEST(FeltHeads, OfBowedSidesAreNoArcs) {
    const auto bowed = [](double bow) {
        std::vector<Point> points;
        for (int i = -8; i <= 8; ++i) {
            const double t = std::abs(i) / 8.0;
            points.push_back({100 - 2 * t, 50 + (i < 0 ? -1 : 1) * (1.6 * t - bow * 4 * t * (1 - t))});
        }
        return points;
    };
    for (const double bow : {0.0, 0.3, -0.3}) {
        Drawing drawing = arrow(30, 10);
        drawing.strokes.push_back({bowed(bow), false});
        make_heads_felt(drawing);
        const bool head = bow >= 0;
        EXPECT_EQ(drawing.strokes[2].role == Role::arrow, head) << bow;
        EXPECT_EQ(drawing.strokes[2].points.size() == 3, head) << bow;
    }
}

TEST(FeltHeads, AreNoLongerThanTheirLine) {
    Drawing drawing = arrow(3, 10);
    drawing.areas.push_back({{{{98.5, 49.5}, {100, 50}, {98.5, 50.5}}}});
    make_heads_felt(drawing);
    EXPECT_LE(box_of(drawing.strokes[2].points).width(), 3);
    Drawing large = arrow(30, 10);
    const std::vector<Point> ring{{90, 46}, {100, 50}, {90, 54}};
    large.areas.push_back({{ring}});
    make_heads_felt(large);
    EXPECT_NEAR(box_of(large.strokes[2].points).width(), 10, 1e-9) << "a large one stays";
}

TEST(FeltHeads, TouchWhatTheyNearlyTouch) {
    for (const double gap : {1.0, 5.0}) {
        Drawing drawing = arrow(30, gap);
        drawing.areas.push_back({{{{98.5, 49.5}, {100, 50}, {98.5, 50.5}}}});
        make_heads_felt(drawing);
        EXPECT_NEAR(box_of(drawing.strokes[2].points).right, gap < 2 ? 101 : 100, 1e-9);
    }
}

// The last mark of a falling curve stands at its end and points along it.
TEST(FeltHeads, MarksOfAPlotAreNone) {
    for (const bool others : {false, true}) {
        Drawing drawing{200, 100, {}, {}, {}};
        drawing.strokes.push_back({{{100, 80}, {100, 60}, {100, 40}, {100, 20}}, false});
        for (const double y : {20.0, 60.0, 40.0})
            if (others || y < 30) drawing.areas.push_back({{{{98, y + 2}, {100, y - 2}, {102, y + 2}}}});
        make_heads_felt(drawing);
        EXPECT_EQ(drawing.areas.size(), others ? 3u : 0u);
        EXPECT_EQ(drawing.strokes.size(), others ? 1u : 2u);
    }
}

TEST(FeltHeads, OtherSmallShapesStay) {
    const std::vector<std::vector<Point>> rings{{{99, 49}, {101, 49}, {101, 51}, {99, 51}},   // a point of a curve
                                                {{99, 49}, {101, 49}, {100, 51}},             // across the line
                                                {{98, 50}, {100, 49}, {102, 50}, {100, 51}},  // a diamond
                                                {{58.5, 49.5}, {60, 50}, {58.5, 50.5}}};      // far from any end
    for (const auto& ring : rings) {
        Drawing drawing = arrow(30, 10);
        drawing.areas.push_back({{ring}});
        make_heads_felt(drawing);
        ASSERT_EQ(drawing.areas.size(), 1u);
        EXPECT_NEAR(height_of(drawing.areas[0].rings[0]), height_of(ring), 1e-9);
        EXPECT_EQ(drawing.areas[0].rings[0].size(), ring.size());
        EXPECT_EQ(drawing.areas[0].role, Role::line);
    }
}

}  // namespace
}  // namespace tactics::felt_heads_test
