// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/touch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tactics::touch_test {
namespace {

constexpr double kLeast = 4.2;

Drawing drawing_of(std::vector<Stroke> strokes) {
    Drawing drawing;
    drawing.width = drawing.height = 200;
    drawing.strokes = std::move(strokes);
    return drawing;
}

Stroke ring(double x, double y, double radius) {
    Stroke stroke;
    stroke.closed = true;
    for (int i = 0; i < 120; ++i)
        stroke.points.push_back(
            {x + radius * std::cos(i * std::numbers::pi / 60), y + radius * std::sin(i * std::numbers::pi / 60)});
    return stroke;
}

double crowded(std::vector<Stroke> strokes) {
    const TouchLoad load = touch_load(drawing_of(std::move(strokes)), kLeast);
    return load.crowded / load.length;
}

TEST(TouchLoad, CountsLinesAndTheirLength) {
    const TouchLoad load = touch_load(drawing_of({{{{0, 0}, {30, 40}}}, {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true}}), kLeast);
    EXPECT_DOUBLE_EQ(load.length, 90);
    EXPECT_EQ(load.strokes, 2u);
    EXPECT_EQ(touch_load(drawing_of({}), kLeast).length, 0);
}

TEST(TouchLoad, LinesSideBySideAreCrowdedOnlyIfTheyAreNear) {
    EXPECT_NEAR(crowded({{{{10, 50}, {110, 50}}}, {{{10, 52}, {110, 52}}}}), 1, 0.01);
    EXPECT_EQ(crowded({{{{10, 50}, {110, 50}}}, {{{10, 54.3}, {110, 54.3}}}}), 0);
    // The second is half as long: 50 of 150 mm lie beside nothing, but for what is near its end.
    EXPECT_NEAR(crowded({{{{10, 50}, {110, 50}}}, {{{10, 53}, {60, 53}}}}), 100.0 / 150, 0.03);
}

TEST(TouchLoad, WhereLinesMeetTheyMay) {
    EXPECT_EQ(crowded({{{{10, 50}, {110, 50}}}, {{{60, 50}, {60, 90}}}}), 0);     // a T
    EXPECT_EQ(crowded({{{{10, 50}, {60, 50}}}, {{{60, 50}, {60, 90}}}}), 0);      // a corner of two strokes
    EXPECT_GT(crowded({{{{10, 50}, {110, 50}}}, {{{60, 50}, {110, 53}}}}), 0.2);  // that then run together
    EXPECT_GT(crowded({{{{10, 50}, {110, 50}}}, {{{60, 52}, {60, 90}}}}), 0);     // ends short of it
}

TEST(TouchLoad, ALineCrowdsItselfOnlyFromFarAlong) {
    EXPECT_EQ(crowded({ring(100, 100, 20)}), 0);
    EXPECT_EQ(crowded({ring(100, 100, 3)}), crowded({ring(40, 40, 3)}));
    EXPECT_EQ(crowded({{{{10, 10}, {50, 10}, {50, 50}}}}), 0);
    EXPECT_GT(crowded({{{{10, 10}, {50, 10}, {50, 12}, {10, 12}}}}), 0.7);  // a hairpin
    EXPECT_NEAR(crowded({ring(100, 100, 20), ring(100, 100, 22)}), 1, 0.01);
}

}  // namespace
}  // namespace tactics::touch_test
