// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "tests/filters/shapes.h"

namespace tactics::thin_crowds_test {
namespace {

Drawing drawn(Drawing drawing, std::string_view steps) { return shapes::drawn(steps, std::move(drawing)); }

constexpr double kBeside = 4.2;  // mm from the middle of a line to that of the next

// An outline across a wood of scratches, each weaker and up to 10 mm long.
Drawing wood(int scratches) {
    Drawing drawing;
    drawing.width = 180;
    drawing.height = 120;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> along(5, 175), down(5, 115), turn(0, 2 * std::numbers::pi), length(2, 10);
    for (int i = 0; i < scratches; ++i) {
        const Point from{along(random), down(random)};
        const double angle = turn(random), mm = length(random);
        drawing.strokes.push_back({{from, {from.x + mm * std::cos(angle), from.y + mm * std::sin(angle)}},
                                   false,
                                   LineClass::normal,
                                   static_cast<float>(10 + 10 * (i % 7))});
    }
    drawing.strokes.push_back({{{20, 60}, {90, 40}, {160, 60}}, false, LineClass::normal, 100});
    return drawing;
}

// The share of the square of 26 mm round a point that lines take with their gaps, by many small steps.
double ground_round(const Drawing& drawing, Point at) {
    constexpr double kHalf = 13, kStep = 0.1;
    double room = 0;
    for (const Stroke& stroke : drawing.strokes)
        for (const Point& p : shapes::walk(stroke, kStep))
            if (std::abs(p.x - at.x) < kHalf && std::abs(p.y - at.y) < kHalf) room += kStep * kBeside;
    const double across = std::min(drawing.width, at.x + kHalf) - std::max(0.0, at.x - kHalf);
    const double down = std::min(drawing.height, at.y + kHalf) - std::max(0.0, at.y - kHalf);
    return room / (across * down);
}

TEST(ThinCrowds, LeavesTheOutlineAndRoomForIt) {
    const Drawing before = wood(1500), after = drawn(before, "thin-crowds");
    ASSERT_EQ(after.strokes.back().points.size(), 3u);
    EXPECT_EQ(after.strokes.back().points[1].y, 40);
    EXPECT_LT(after.strokes.size(), before.strokes.size() / 2);
    ASSERT_EQ(after.remarks.size(), 1u);
    EXPECT_NE(after.remarks[0].english().find("Of 1501 edges, " + std::to_string(1501 - after.strokes.size()) + " short ones"),
              std::string::npos);
    double most = 0, all = 0;
    for (const Stroke& stroke : after.strokes) {
        const double ground = ground_round(after, stroke.points[0]);
        most = std::max(most, ground);
        all += ground / static_cast<double>(after.strokes.size());
    }
    EXPECT_LT(most, 0.9);
    EXPECT_LT(all, 0.65);
    EXPECT_GT(all, 0.45);  // and no more than that went
}

TEST(ThinCrowds, TakesTheWeakestFirst) {
    const auto share = [](const Drawing& drawing) {
        const auto strong =
            std::count_if(drawing.strokes.begin(), drawing.strokes.end(), [](const Stroke& s) { return s.strength >= 60; });
        return static_cast<double>(strong) / static_cast<double>(drawing.strokes.size());
    };
    EXPECT_GT(share(drawn(wood(1500), "thin-crowds")), 1.4 * share(wood(1500)));
}

TEST(ThinCrowds, LeavesWhatHasRoomAndWhatIsLong) {
    EXPECT_EQ(drawn(wood(100), "thin-crowds").strokes.size(), 101u);
    EXPECT_EQ(drawn(wood(1500), "thin-crowds short=1mm").strokes.size(), 1501u);
    EXPECT_EQ(drawn(wood(1500), "thin-crowds ground=100").strokes.size(), 1501u);
}

// The eyes and the mouth of a face on a small sheet are a crowd, too.
TEST(ThinCrowds, LeavesAFew) {
    EXPECT_EQ(drawn(wood(1500), "thin-crowds ground=0").strokes.size(), 100u);
    EXPECT_EQ(drawn(wood(1500), "thin-crowds ground=0 few=300").strokes.size(), 300u);
    Drawing small = wood(90);
    for (Stroke& stroke : small.strokes)
        for (Point& p : stroke.points) p = {p.x / 6, p.y / 6};
    small.width /= 6, small.height /= 6;
    EXPECT_EQ(drawn(small, "thin-crowds").strokes.size(), 91u);
}

TEST(ThinCrowds, HasNoMoreToDoAfterwards) {
    const Drawing once = drawn(wood(1500), "thin-crowds");
    EXPECT_EQ(drawn(once, "thin-crowds").strokes.size(), once.strokes.size());
}

TEST(ThinCrowds, OutsideTheDrawingAndOfAPointDoesNoHarm) {
    Drawing drawing = wood(1500);
    drawing.strokes.push_back({{{-5, -5}, {400, 300}}, false, LineClass::normal, 1});
    drawing.strokes.push_back({{{90, 60}}, false, LineClass::normal, 1});
    drawing.strokes.push_back({{}, false, LineClass::normal, 1});
    EXPECT_LT(drawn(drawing, "thin-crowds").strokes.size(), 800u);
}

}  // namespace
}  // namespace tactics::thin_crowds_test
