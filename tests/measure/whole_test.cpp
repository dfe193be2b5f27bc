// SPDX-License-Identifier: Apache-2.0
#include "tactics/measure/whole.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tactics::whole_test {
namespace {

Drawing drawing(std::vector<Stroke> strokes) {
    Drawing made;
    made.width = 200;
    made.height = 200;
    made.strokes = std::move(strokes);
    // Corners far away, so that the lines in the middle are not at the side of all lines.
    made.areas.push_back({{{{0, 0}, {1, 0}, {0, 1}}}});
    made.areas.push_back({{{{200, 200}, {199, 200}, {200, 199}}}});
    return made;
}

constexpr double kCorners = 4 + 2 * 1.4142135623730951;

TEST(Whole, ALineThatEndsInNothingHasTwoLooseEnds) {
    const WholeLines alone = whole_lines(drawing({{{{50, 50}, {90, 50}}}}));
    EXPECT_EQ(alone.lines, 3u);
    EXPECT_EQ(alone.loose_ends, 2u);
    EXPECT_NEAR(alone.length, 40 + kCorners, 1e-9);
    EXPECT_NEAR(alone.whole, kCorners, 1e-9);
}

TEST(Whole, ClosedLinesHaveNone) {
    const WholeLines ring = whole_lines(drawing({{{{50, 50}, {90, 50}, {90, 90}}, true}}));
    EXPECT_EQ(ring.loose_ends, 0u);
    EXPECT_DOUBLE_EQ(ring.whole, ring.length);
    // Open, but its ends are 3 mm apart: as good as closed if it is long.
    EXPECT_EQ(whole_lines(drawing({{{{50, 50}, {90, 50}, {90, 90}, {50, 53}}}})).loose_ends, 0u);
    EXPECT_EQ(whole_lines(drawing({{{{50, 50}, {56, 50}, {56, 53}, {51, 53}}}})).loose_ends, 2u);  // 14 mm
}

TEST(Whole, AnEndOnALineOrAtTheSideIsHeld) {
    const Stroke wall{{{100, 20}, {100, 180}}};
    // The wall ends in nothing; one end of the beam is 3.9 mm from its middle.
    const WholeLines beam = whole_lines(drawing({wall, {{{50, 100}, {96.1, 100}}}}));
    EXPECT_EQ(beam.loose_ends, 3u);
    EXPECT_EQ(whole_lines(drawing({wall, {{{50, 100}, {95.9, 100}}}})).loose_ends, 4u);
    EXPECT_EQ(whole_lines(drawing({wall, {{{50, 100}, {95.9, 100}}}}), 5).loose_ends, 3u);
    EXPECT_EQ(whole_lines(drawing({{{{3, 100}, {150, 100}}}})).loose_ends, 1u);
    EXPECT_EQ(whole_lines(drawing({{{{3, 100}, {197, 100}}}})).loose_ends, 0u);
}

TEST(Whole, OnlyWhatTheDrawingIsAbout) {
    Stroke mark{{{50, 50}, {90, 50}}};
    mark.role = Role::pattern;
    EXPECT_EQ(whole_lines(drawing({mark})).lines, 2u);
    EXPECT_EQ(whole_lines(Drawing{}).lines, 0u);
}

}  // namespace
}  // namespace tactics::whole_test
