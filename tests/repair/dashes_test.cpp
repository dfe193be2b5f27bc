// SPDX-License-Identifier: Apache-2.0
// Dashed lines, which are cut after everything else is mended.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tactics/layout/lay_out.h"
#include "tactics/page.h"
#include "tactics/repair/repair.h"
#include "tactics/rules/rule.h"

namespace tactics::dashes_test {
namespace {

Drawing blank() {
    Drawing drawing;
    drawing.width = 180;
    drawing.height = 250;
    return drawing;
}

Stroke dashed(std::vector<Point> points, bool closed = false) {
    return {std::move(points), closed, LineClass::normal, 0, Role::dash};
}

std::size_t dashes_of(const Drawing& drawing) {
    return static_cast<std::size_t>(std::count_if(drawing.strokes.begin(), drawing.strokes.end(),
                                                  [](const Stroke& stroke) { return stroke.role == Role::dash; }));
}

// Places that break any of these rules, as it would be printed.
std::size_t places(const Drawing& drawing, const Medium& medium, std::initializer_list<std::string_view> rules) {
    Sheet sheet;
    sheet.paper = {"", "", drawing.width, drawing.height};
    sheet.medium = &medium;
    sheet.bare = true;
    sheet.margin = 0;
    std::size_t count = 0;
    for (const Verdict& verdict : check_page(lay_out(drawing, sheet), demands_of(medium)))
        for (const std::string_view rule : rules)
            if (verdict.demand.rule->name == rule) count += verdict.findings.places.size();
    return count;
}

TEST(Dashes, AreAsTheRulesHaveThemOnEveryMedium) {
    for (const Medium& medium : media()) {
        Drawing drawing = blank();
        drawing.strokes.push_back(dashed({{10, 20}, {170, 40}}));
        drawing.strokes.push_back(dashed({{10, 60}, {100, 90}, {170, 60}}));
        std::vector<Point> circle;
        for (int i = 0; i < 90; ++i)
            circle.push_back({90 + 40 * std::cos(i * std::numbers::pi / 45), 170 + 40 * std::sin(i * std::numbers::pi / 45)});
        drawing.strokes.push_back(dashed(circle, true));
        const Repaired repaired = repair(drawing, medium);
        EXPECT_GT(dashes_of(repaired.drawing), 40u) << medium.name;
        EXPECT_EQ(places(repaired.drawing, medium, {"dash-length", "long-dashes", "dash-gaps", "gap", "merging-dots"}), 0u)
            << medium.name;
        EXPECT_EQ(repaired.broken_after, 0u);
        EXPECT_DOUBLE_EQ(repaired.kept, 1);
    }
}

TEST(Dashes, RunThroughWhereOthersCross) {
    Drawing drawing = blank();
    drawing.strokes.push_back(dashed({{10, 100}, {170, 100}}));
    for (const double x : {31.0, 77.0, 122.5}) drawing.strokes.push_back({{{x, 20}, {x + 5, 200}}, false});
    const Medium& swell = find_medium("swell", "test");
    const Repaired repaired = repair(drawing, swell);
    EXPECT_EQ(repaired.broken_after, 0u);
    EXPECT_EQ(places(repaired.drawing, swell, {"gap", "dash-length"}), 0u);
    for (const double x : {31.0, 77.0, 122.5}) {
        const double crossing = x + 5 * 80.0 / 180;
        const bool through =
            std::any_of(repaired.drawing.strokes.begin(), repaired.drawing.strokes.end(), [&](const Stroke& stroke) {
                return stroke.role == Role::dash && stroke.points.front().x < crossing - 3 &&
                       stroke.points.back().x > crossing + 3;
            });
        EXPECT_TRUE(through) << x;
    }
}

// A finger finds a corner by the line that goes round it; ends on both sides of it would be one shape.
TEST(Dashes, GoRoundCorners) {
    const Medium& swell = find_medium("swell", "test");
    for (const bool closed : {false, true})
        for (int scene = 0; scene < 60; ++scene) {
            Drawing drawing = blank();
            const double wide = 40 + 0.7 * scene, high = 50 + 1.3 * scene;
            const std::vector<Point> corners = {{20, 20}, {20 + wide, 20}, {20 + wide, 20 + high}, {20, 20 + high}};
            drawing.strokes.push_back(dashed(corners, closed));
            ASSERT_TRUE(cut_dashes(drawing, swell));
            EXPECT_EQ(places(drawing, swell, {"gap", "dash-length", "dash-gaps"}), 0u) << scene;
            for (const Point& corner : corners)
                EXPECT_TRUE(std::any_of(drawing.strokes.begin(), drawing.strokes.end(),
                                        [&](const Stroke& dash) {
                                            return std::any_of(dash.points.begin(), dash.points.end(),
                                                               [&](const Point& at) { return distance(at, corner) < 0.01; });
                                        }))
                    << scene << ": " << corner.x << " " << corner.y;
        }
}

TEST(Dashes, HaveNoGapBetweenTwoCloseCorners) {
    const Medium& swell = find_medium("swell", "test");
    for (double w = 4.5; w < 30; w += 0.5) {  // with less the lines themselves are too close
        Drawing drawing = blank();
        drawing.strokes.push_back(dashed({{20, 20}, {100, 20}, {100, 20 + w}, {20, 20 + w}, {20, 140}}));
        ASSERT_TRUE(cut_dashes(drawing, swell));
        EXPECT_EQ(places(drawing, swell, {"gap"}), 0u) << w;
    }
}

// Too round for a dash that goes round a corner, and less far straight across than a gap.
TEST(Dashes, HaveTheirGapAcrossARoundCorner) {
    const Medium& swell = find_medium("swell", "test");
    for (double radius = 0.5; radius < 4; radius += 0.5)
        for (double before = 20; before < 34; before += 0.5) {
            Drawing drawing = blank();
            std::vector<Point> line{{20, 20 + before}};
            for (int i = 0; i <= 6; ++i) {
                const double angle = i * 3.14159265 / 12;
                line.push_back({20 + radius * (1 - std::cos(angle)), 20 + radius * (1 - std::sin(angle))});
            }
            line.push_back({110, 20});
            drawing.strokes.push_back(dashed(line));
            ASSERT_TRUE(cut_dashes(drawing, swell));
            EXPECT_EQ(places(drawing, swell, {"gap"}), 0u) << radius << ", " << before;
        }
}

// So many corners that a dash round each would leave no gap.
TEST(Dashes, HaveGapsBetweenCloseCorners) {
    const Medium& swell = find_medium("swell", "test");
    Drawing drawing = blank();
    std::vector<Point> zigzag;
    for (int i = 0; i < 30; ++i) zigzag.push_back({10 + 4.0 * i, i % 2 == 0 ? 50.0 : 54.0});
    drawing.strokes.push_back(dashed(zigzag));
    ASSERT_TRUE(cut_dashes(drawing, swell));
    EXPECT_GT(drawing.strokes.size(), 8u);
}

TEST(Dashes, ShortLinesAndDashesThatAreCutAlreadyStayWhole) {
    Drawing drawing = blank();
    drawing.strokes.push_back(dashed({{10, 20}, {22, 20}}));
    drawing.strokes.push_back(dashed({{10, 60}, {170, 60}}));
    const Medium& swell = find_medium("swell", "test");
    cut_dashes(drawing, swell);
    const std::size_t count = drawing.strokes.size();
    EXPECT_GT(count, 10u);
    EXPECT_DOUBLE_EQ(drawing.strokes[0].points[1].x, 22);
    // From end to end.
    EXPECT_DOUBLE_EQ(drawing.strokes[1].points.front().x, 10);
    EXPECT_NEAR(drawing.strokes.back().points.back().x, 170, 1e-9);
    cut_dashes(drawing, swell);
    EXPECT_EQ(drawing.strokes.size(), count);
}

// An end beside the other leg of a sharp bend would be; and what is still broken is counted after the dashes are cut.
TEST(Dashes, CuttingBreaksNothingAndWhatIsBrokenIsCounted) {
    const Medium& swell = find_medium("swell", "test");
    for (int scene = 0; scene < 80; ++scene) {
        Drawing drawing = blank();
        const double angle = (29 + scene % 8) * std::numbers::pi / 180, leg = 40 + scene / 8;
        drawing.strokes.push_back(
            dashed({{20 + leg, 100}, {20, 100}, {20 + leg * std::cos(angle), 100 + leg * std::sin(angle)}}));
        const Repaired repaired = repair(drawing, swell);
        std::size_t broken = 0;
        for (const Demand& demand : demands_of(swell))
            if (demand.rule->hard) broken += places(repaired.drawing, swell, {demand.rule->name});
        EXPECT_EQ(repaired.broken_after, broken) << scene;
        EXPECT_TRUE(repaired.broken_before > 0 || broken == 0) << scene;
    }
}

// Dots beside another line would be felt as a part of it; without them the row goes on behind it.
TEST(Dashes, DottedLinesAreRowsOfDotsClearOfOthers) {
    for (const char* name : {"swell", "embosser"}) {
        const Medium& medium = find_medium(name, "test");
        Drawing drawing = blank();
        drawing.strokes.push_back({{{10, 100}, {170, 100}}, false, LineClass::thick, 0, Role::dots});
        drawing.strokes.push_back({{{77, 20}, {82, 200}}, false});
        drawing.strokes.push_back({{{10, 150}, {12, 150}}, false, LineClass::thick, 0, Role::dots});  // too short
        ASSERT_TRUE(cut_dashes(drawing, medium));
        EXPECT_EQ(places(drawing, medium, {"gap"}), 0u);
        std::size_t dots = 0;
        bool before = false, behind = false;
        for (const Stroke& stroke : drawing.strokes) {
            EXPECT_NE(stroke.role, Role::dots);
            if (stroke.role != Role::dash || stroke.points[0].y != 100) continue;
            ++dots;
            EXPECT_LT(length_of(stroke), 0.1);
            before = before || stroke.points[0].x < 30;
            behind = behind || stroke.points[0].x > 150;
        }
        EXPECT_GT(dots, 15u);
        EXPECT_TRUE(before && behind);
    }
}

// It leaves the side of a box at so small an angle that it would be felt as a part of that.
TEST(Dashes, AShortDottedLinkBesideALineIsNone) {
    const Medium& swell = find_medium("swell", "test");
    for (const double rise : {1.5, 9.0}) {
        Drawing drawing = blank();
        drawing.strokes.push_back({{{20, 100}, {160, 100}}, false, LineClass::normal, 0, Role::line});
        drawing.strokes.push_back({{{71, 60}, {71, 99 - rise}}, false, LineClass::normal, 0, Role::line});
        drawing.strokes.push_back({{{60, 100}, {70, 100 - rise}}, false, LineClass::thick, 0, Role::dots});
        cut_dashes(drawing, swell);
        const bool there = std::any_of(drawing.strokes.begin(), drawing.strokes.end(), [](const Stroke& stroke) {
            return stroke.points.size() == 2 && stroke.points[1].x == 70;
        });
        EXPECT_EQ(there, rise > 5);
    }
}

// On a wave, as pixels have it, the next dot is less far straight across: it stands farther on, and none is missing.
// The link of two boxes, with a head, is as close to both as any of its dots would be; a curve that goes on is not.
TEST(Dashes, AShortDottedLinkIsALineButWhatIsLeftOfACurveIsNone) {
    const Medium& swell = find_medium("swell", "test");
    for (const bool curve : {false, true}) {
        Drawing drawing = blank();
        for (const double x : {60.0, 71.0})
            drawing.strokes.push_back({{{x, 40}, {x, 160}}, false, LineClass::normal, 0, Role::line});
        drawing.strokes.push_back({{{60, 100}, {71, 100}}, false, LineClass::thick, 0, Role::dots});
        if (curve) {
            drawing.strokes.push_back({{{10, 100}, {59, 100}}, false, LineClass::thick, 0, Role::dots});
            drawing.strokes.push_back({{{72, 100}, {150, 100}}, false, LineClass::thick, 0, Role::dots});
        }
        cut_dashes(drawing, swell);
        const bool there = std::any_of(drawing.strokes.begin(), drawing.strokes.end(), [](const Stroke& stroke) {
            return stroke.points.size() == 2 && stroke.points[0].x == 60 && stroke.points[1].x == 71;
        });
        EXPECT_EQ(there, !curve);
    }
}

TEST(Dashes, NoDotOfACurveIsMissing) {
    const Medium& medium = find_medium("swell", "test");
    for (double bend = 12; bend < 40; ++bend) {
        Drawing drawing = blank();
        Stroke wave{{}, false, LineClass::thick, 0, Role::dots};
        for (double x = 10; x <= 170; x += 1.5)
            wave.points.push_back({x, 0.8 * std::round((100 + 0.7 * bend * std::sin(x / bend)) / 0.8)});
        drawing.strokes.push_back(wave);
        ASSERT_TRUE(cut_dashes(drawing, medium));
        for (std::size_t i = 1; i < drawing.strokes.size(); ++i)
            EXPECT_LT(distance(drawing.strokes[i - 1].points[0], drawing.strokes[i].points[0]),
                      1.5 * (medium.gap + medium.thick_line))
                << bend;
        EXPECT_EQ(places(drawing, medium, {"gap"}), 0u);
    }
}

// Two parts of a line that end on a row of dots touch only through it.
TEST(Dashes, WhatMetOnALineOfDotsStaysJoined) {
    const Medium& medium = find_medium("swell", "test");
    Drawing drawing = blank();
    drawing.strokes.push_back({{{10, 100}, {170, 100}}, false, LineClass::thick, 0, Role::dots});
    drawing.strokes.push_back({{{80, 20}, {80, 99}}, false});
    drawing.strokes.push_back({{{82, 101}, {82, 200}}, false});
    drawing.strokes.push_back({{{121, 100}, {124, 100}}, false, LineClass::thick, 0, Role::dots});  // what repair left of another
    drawing.strokes.push_back({{{120, 20}, {120, 100}}, false});
    drawing.strokes.push_back({{{125, 100}, {125, 200}}, false});
    ASSERT_TRUE(cut_dashes(drawing, medium));
    EXPECT_EQ(places(drawing, medium, {"gap"}), 0u);
    std::size_t dots = 0;
    for (const Stroke& stroke : drawing.strokes) dots += stroke.line == LineClass::thick && length_of(stroke) < 0.1 ? 1 : 0;
    EXPECT_GT(dots, 10u);
}

// An embosser has no thick lines: dots behind its dashes say that a line is not one of the thin dashed ones, if there are any.
TEST(Dashes, ThickOnesHaveDotsOnAnEmbosserOnlyBesideThinOnes) {
    const Medium& medium = find_medium("embosser", "test");
    for (const bool beside_thin : {false, true}) {
        Drawing drawing = blank();
        drawing.strokes.push_back({{{10, 100}, {170, 100}}, false, LineClass::thick, 0, Role::dash});
        drawing.strokes.push_back(
            {{{10, 150}, {170, 150}}, false, beside_thin ? LineClass::normal : LineClass::thick, 0, Role::dash});
        ASSERT_TRUE(cut_dashes(drawing, medium));
        std::size_t dots = 0, dashes = 0;
        for (const Stroke& stroke : drawing.strokes) ++(length_of(stroke) < 0.1 ? dots : dashes);
        EXPECT_EQ(dots > 0, beside_thin);
        EXPECT_GT(dashes, 10u);
    }
}

TEST(Dashes, OfVeryManyTheLastStayWhole) {
    const Medium& swell = find_medium("swell", "test");
    Drawing drawing = blank();
    constexpr std::size_t kLines = 6000;
    drawing.height = 10.0 * kLines;
    for (std::size_t i = 0; i < kLines; ++i) {
        const double y = 5 + 10 * static_cast<double>(i);
        drawing.strokes.push_back(dashed({{10, y}, {170, y}}));
    }
    EXPECT_TRUE(cut_dashes(drawing, swell));
    EXPECT_GT(drawing.strokes.size(), kLines);
    EXPECT_LT(drawing.strokes.size(), kLines + 50000);
    EXPECT_DOUBLE_EQ(drawing.strokes.back().points.front().x, 10);
    EXPECT_DOUBLE_EQ(drawing.strokes.back().points.back().x, 170);
    Drawing whole = blank();
    whole.strokes.push_back({{{10, 20}, {170, 20}}, false});
    EXPECT_FALSE(cut_dashes(whole, swell));
}

}  // namespace
}  // namespace tactics::dashes_test
