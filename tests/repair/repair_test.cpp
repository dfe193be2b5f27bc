// SPDX-License-Identifier: Apache-2.0
// What repair promises: no hard rule is broken afterwards, and no more was changed than that needs.
#include "tactics/repair/repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tactics/geometry/course.h"
#include "tactics/layout/lay_out.h"
#include "tactics/measure/random.h"
#include "tactics/page.h"
#include "tactics/rules/rule.h"
#include "tests/near_strokes.h"

namespace tactics::repair_test {
namespace {

using tests::distance_to;

const Medium& swell() { return find_medium("swell", "test"); }

Drawing blank() {
    Drawing drawing;
    drawing.width = 180;
    drawing.height = 250;
    return drawing;
}

// Told by the rules themselves, on the page that would be printed.
std::size_t hard_places(const Drawing& drawing, const Medium& medium = swell()) {
    Sheet sheet;
    sheet.paper = {"", "", drawing.width, drawing.height};
    sheet.medium = &medium;
    sheet.bare = true;
    sheet.margin = 0;
    std::size_t places = 0;
    for (const Verdict& verdict : check_page(lay_out(drawing, sheet), demands_of(medium)))
        if (verdict.demand.rule->hard) places += verdict.findings.places.size();
    return places;
}

std::size_t count(const Repaired& repaired, Mend::Kind kind) {
    return static_cast<std::size_t>(
        std::count_if(repaired.changes.begin(), repaired.changes.end(), [kind](const Mend& mend) { return mend.kind == kind; }));
}

bool same(const Drawing& a, const Drawing& b) {
    return std::equal(
        a.strokes.begin(), a.strokes.end(), b.strokes.begin(), b.strokes.end(), [](const Stroke& s, const Stroke& t) {
            return s.closed == t.closed && std::equal(s.points.begin(), s.points.end(), t.points.begin(), t.points.end(),
                                                      [](Point p, Point q) { return p.x == q.x && p.y == q.y; });
        });
}

// Wavy lines here and there, some closed, some nearly on each other.
Drawing random_drawing(std::uint64_t seed, int lines) {
    RandomNumbers random(seed);
    Drawing drawing = blank();
    for (int i = 0; i < lines; ++i) {
        Stroke stroke;
        Point at;
        at.x = 10 + 160 * random.uniform();
        at.y = 10 + 230 * random.uniform();
        double heading = 6.28 * random.uniform();
        const double bend = 0.4 * (random.uniform() - 0.5);
        const int steps = 5 + static_cast<int>(40 * random.uniform());
        for (int k = 0; k < steps; ++k) {
            stroke.points.push_back(at);
            at = {std::clamp(at.x + 2 * std::cos(heading), 0.0, 180.0), std::clamp(at.y + 2 * std::sin(heading), 0.0, 250.0)};
            heading += bend;
        }
        stroke.closed = random.uniform() < 0.2;
        stroke.strength = static_cast<float>(1 + 50 * random.uniform());
        stroke.line = random.uniform() < 0.2 ? LineClass::thin : LineClass::normal;
        drawing.strokes.push_back(std::move(stroke));
    }
    return drawing;
}

TEST(Repair, LeavesAloneWhatIsFitToBeFelt) {
    Drawing drawing = blank();
    drawing.strokes.push_back({{{20, 20}, {120, 20}}});
    drawing.strokes.push_back({{{20, 24.3}, {120, 24.3}}});  // 3.3 mm of white
    drawing.strokes.push_back({{{60, 24.3}, {60, 90}}});     // ends on it
    drawing.strokes.push_back({{{20, 60}, {120, 60}}});      // crosses that one, and neither is less
    drawing.areas.push_back({{{{20, 100}, {60, 100}, {60, 140}, {20, 140}}}});
    const Repaired repaired = repair(drawing, swell());
    EXPECT_TRUE(same(repaired.drawing, drawing));
    EXPECT_EQ(repaired.drawing.areas.size(), 1u);
    EXPECT_EQ(repaired.changes.size(), 0u);
    EXPECT_EQ(repaired.broken_before, 0u);
    EXPECT_EQ(repaired.kept, 1);
    EXPECT_TRUE(notes_of(repaired).empty());
}

TEST(Repair, BendsLinesApartThatAreNearlyFarEnough) {
    Drawing drawing = blank();
    drawing.strokes.push_back({{{20, 20}, {120, 20}}});
    drawing.strokes.push_back({{{20, 23}, {120, 23}}});  // 2 mm of white
    drawing.strokes.push_back({{{60, 23}, {60, 90}}});   // goes with the line that it ends on
    ASSERT_EQ(hard_places(drawing), 2u);                 // also with the third
    const Repaired repaired = repair(drawing, swell());
    EXPECT_EQ(repaired.broken_before, 2u);
    EXPECT_EQ(hard_places(repaired.drawing), 0u);
    ASSERT_EQ(repaired.drawing.strokes.size(), 3u);
    EXPECT_EQ(count(repaired, Mend::Kind::moved), repaired.changes.size());
    EXPECT_GT(repaired.kept, 0.99);
    for (const Stroke& stroke : repaired.drawing.strokes)
        for (const Point& p : stroke.points) EXPECT_LE(distance_to(drawing.strokes, p), 1.001);
    Drawing second = blank();
    second.strokes.push_back(repaired.drawing.strokes[1]);
    EXPECT_LT(distance_to(second.strokes, repaired.drawing.strokes[2].points[0]), 0.1);
}

TEST(Repair, OfTwoLinesAlongEachOtherTheStrongerStays) {
    Drawing drawing = blank();
    drawing.strokes.push_back({{{20, 21.5}, {120, 21.5}}, false, LineClass::normal, 10});
    drawing.strokes.push_back({{{10, 20}, {150, 20}}, false, LineClass::normal, 30});
    drawing.strokes.push_back({{{20, 100}, {120, 100}}, false, LineClass::normal, 5});
    const Repaired repaired = repair(drawing, swell());
    ASSERT_EQ(repaired.drawing.strokes.size(), 2u);
    EXPECT_EQ(repaired.drawing.strokes[0].strength, 30);
    EXPECT_EQ(length_of(repaired.drawing.strokes[0]), 140);
    EXPECT_EQ(count(repaired, Mend::Kind::left_out), 1u);
    EXPECT_NEAR(repaired.kept, 240.0 / 340, 1e-9);
    EXPECT_EQ(in_language(notes_of(repaired), "en"),
              std::vector<std::string>{"1 line or area too close to others was left out, 100 mm."});
    // Only where it runs along: the rest of it stays.
    drawing.strokes[0].points = {{20, 21.5}, {60, 21.5}, {60, 80}};
    const Repaired part = repair(drawing, swell());
    ASSERT_EQ(part.drawing.strokes.size(), 3u);
    EXPECT_EQ(hard_places(part.drawing), 0u);
    EXPECT_EQ(count(part, Mend::Kind::merged), 1u);
    EXPECT_NEAR(length_of(part.drawing.strokes[0]), 80 - 20 - 0.5 - 0.5 - 3.2, 1.6);
}

TEST(Repair, LeadsAnEndOntoTheLineThatItNearlyMeets) {
    Drawing drawing = blank();
    drawing.strokes.push_back({{{20, 50}, {120, 50}}});
    drawing.strokes.push_back({{{60, 52.2}, {60, 90}}});  // 1.2 mm short of it
    drawing.strokes.push_back({{{90, 53.2}, {90, 90}}});  // 2.2 mm: it is cut back instead, or bent
    const Repaired repaired = repair(drawing, swell());
    EXPECT_EQ(count(repaired, Mend::Kind::joined), 1u);
    EXPECT_EQ(hard_places(repaired.drawing), 0u);
    ASSERT_EQ(repaired.drawing.strokes.size(), 3u);
    EXPECT_EQ(repaired.drawing.strokes[1].points.front().y, 50);
    EXPECT_GT(repaired.drawing.strokes[2].points.front().y, 53.2);
}

TEST(Repair, BreaksTheLesserLineAtACrossing) {
    Drawing drawing = blank();
    drawing.strokes.push_back({{{20, 50}, {120, 50}}, false, LineClass::thick});
    drawing.strokes.push_back({{{60, 10}, {60, 100}}, false, LineClass::thin});
    drawing.strokes.push_back({{{80, 45}, {80, 55}}, false, LineClass::thin});  // nothing would be left of it
    const Repaired repaired = repair(drawing, swell());
    EXPECT_EQ(hard_places(repaired.drawing), 0u);
    ASSERT_EQ(repaired.drawing.strokes.size(), 4u);
    EXPECT_EQ(count(repaired, Mend::Kind::broken), 1u);
    Drawing thick = blank();
    thick.strokes.push_back(drawing.strokes[0]);
    for (const std::size_t i : {1, 2})
        for (const Point& p : repaired.drawing.strokes[i].points) EXPECT_GE(distance_to(thick.strokes, p), 3.2 + 1.5 + 0.35);
    EXPECT_TRUE(same(repair(repaired.drawing, swell()).drawing, repaired.drawing));
}

TEST(Repair, AreasTooCloseBecomeOutlinesAndSmallOnesGo) {
    Drawing drawing = blank();
    const auto square = [](double x, double y, double side) {
        return Area{{{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}}};
    };
    drawing.areas = {square(20, 20, 40), square(62, 20, 39), square(20, 62, 5)};
    const Repaired repaired = repair(drawing, swell());
    EXPECT_EQ(hard_places(repaired.drawing), 0u);
    ASSERT_EQ(repaired.drawing.areas.size(), 1u);
    EXPECT_EQ(repaired.drawing.areas[0].rings[0][0].x, 20);
    EXPECT_EQ(count(repaired, Mend::Kind::outlined), 1u);
    EXPECT_EQ(count(repaired, Mend::Kind::left_out), 1u);
    EXPECT_FALSE(repaired.drawing.strokes.empty());
}

std::vector<Area> discs_at(const std::vector<Point>& middles, double radius) {
    std::vector<Area> discs;
    for (const Point& middle : middles) {
        std::vector<Point> ring;
        for (int i = 0; i < 24; ++i)
            ring.push_back(
                {middle.x + radius * std::cos(i * 3.14159265 / 12), middle.y + radius * std::sin(i * 3.14159265 / 12)});
        discs.push_back({{ring}});
    }
    return discs;
}

Point middle_of(const Area& disc) {
    const Point a = disc.rings[0][0], b = disc.rings[0][12];
    return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

// 3.2 mm should be between them.
TEST(Repair, PointsOfAChartMoveAsFarAsAFingerCannotTell) {
    Drawing drawing = blank();
    drawing.areas = discs_at({{20, 20}, {25, 20}, {60, 20}}, 1.5);
    const Repaired repaired = repair(drawing, swell());
    EXPECT_EQ(hard_places(repaired.drawing), 0u);
    ASSERT_EQ(repaired.drawing.areas.size(), 3u);
    EXPECT_EQ(count(repaired, Mend::Kind::shifted), 2u);
    for (std::size_t i = 0; i < 3; ++i) {
        const Point from = drawing.areas[i].rings[0][0], to = repaired.drawing.areas[i].rings[0][0];
        EXPECT_LE(distance(from, to), i < 2 ? 1.01 : 0.011);
    }
}

// However often lines that stood between them go.
TEST(Repair, NoPointGoesFartherThanAFingerCanTell) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        RandomNumbers random(seed);
        Drawing drawing = blank();
        std::vector<Point> middles;
        for (int i = 0; i < 60; ++i) middles.push_back({10 + 100 * random.uniform(), 10 + 100 * random.uniform()});
        drawing.areas = discs_at(middles, 1.5);
        for (int i = 0; i < 8; ++i) drawing.strokes.push_back({{{5, 10 + 12.0 * i}, {115, 12 + 11.0 * i}}, false});
        const Repaired repaired = repair(drawing, swell());
        EXPECT_EQ(hard_places(repaired.drawing), 0u);
        for (const Area& disc : repaired.drawing.areas) {
            double nearest = 1e9;
            for (const Area& from : drawing.areas) nearest = std::min(nearest, distance(middle_of(disc), middle_of(from)));
            EXPECT_LE(nearest, 1.01 + 0.01);
        }
    }
}

TEST(Repair, PointsThatLoseTheirRimsStayAlike) {
    Drawing drawing = blank();
    drawing.areas = discs_at({{20, 20}, {25.5, 20}, {60, 20}}, 1.5);
    for (const Area& disc : drawing.areas) drawing.strokes.push_back({disc.rings[0], true});
    drawing.strokes.push_back({{{20, 60}, {100, 60}}, false});
    const Repaired repaired = repair(drawing, swell());
    EXPECT_EQ(hard_places(repaired.drawing), 0u);
    EXPECT_EQ(repaired.drawing.areas.size(), 3u);
    EXPECT_EQ(repaired.drawing.strokes.size(), 1u);
    drawing.areas[1] = discs_at({{80, 80}}, 1.5)[0];
    drawing.strokes[1].points = drawing.areas[1].rings[0];
    EXPECT_EQ(repair(drawing, swell()).drawing.strokes.size(), 4u);
}

// Of three in a row the middle one hides that the outer ones are too close.
TEST(Repair, PointsThatCannotMoveFarEnoughGoUntilNoneIsTooClose) {
    Drawing drawing = blank();
    std::vector<Point> heap;
    for (int i = 0; i < 9; ++i) heap.push_back({40 + 1.7 * (i % 3), 40 + 1.7 * (i / 3)});
    heap.insert(heap.end(), {{80, 80}, {83, 80}, {86, 80}, {30, 90}});
    drawing.areas = discs_at(heap, 1.5);
    const Repaired repaired = repair(drawing, swell());
    EXPECT_EQ(hard_places(repaired.drawing), 0u);
    EXPECT_EQ(repaired.broken_after, 0u);
    EXPECT_GE(repaired.drawing.areas.size(), 3u);
    const std::size_t gone = count(repaired, Mend::Kind::left_out);
    EXPECT_GT(gone, 0u);
    // Those of a plot are told as points.
    for (Area& area : drawing.areas) area.role = Role::symbol;
    const Repaired plot = repair(drawing, swell());
    EXPECT_EQ(count(plot, Mend::Kind::crowded), gone);
    EXPECT_EQ(count(plot, Mend::Kind::left_out), 0u);
}

// A texture lies along its outline; only things near the outline conflict, and the pattern yields on its own.
TEST(Repair, TexturesStayInTheirOutlines) {
    Drawing drawing = blank();
    const std::vector<Point> ring{{20, 20}, {120, 20}, {120, 120}, {20, 120}},
        beside{{120, 20}, {170, 20}, {170, 120}, {120, 120}};
    drawing.strokes.push_back({ring, true});
    drawing.areas.push_back({{ring}, Role::line, 1});
    drawing.areas.push_back({{beside}, Role::line, 2});
    const Repaired nothing = repair(drawing, swell());
    EXPECT_TRUE(nothing.changes.empty() && same(nothing.drawing, drawing));
    drawing.strokes.push_back({{{20, 122}, {120, 122}}, false});
    const Repaired mended = repair(drawing, swell());
    EXPECT_FALSE(mended.changes.empty());
    EXPECT_EQ(mended.drawing.areas.size(), 2u);
    EXPECT_EQ(count(mended, Mend::Kind::outlined), 0u);
    EXPECT_EQ(hard_places(mended.drawing), 0u);
}

TEST(Repair, WhatIsTooBlackBecomesOutlines) {
    Drawing drawing = blank();
    drawing.areas.push_back({{{{0, 0}, {180, 0}, {180, 150}, {0, 150}}, {{20, 20}, {60, 20}, {60, 60}}}});
    drawing.areas.push_back({{{{20, 180}, {80, 180}, {80, 240}, {20, 240}}}});
    ASSERT_GT(hard_places(drawing), 0u);
    const Repaired repaired = repair(drawing, swell());
    EXPECT_EQ(hard_places(repaired.drawing), 0u);
    EXPECT_EQ(repaired.drawing.areas.size(), 1u);  // the smaller one stays black
    EXPECT_EQ(repaired.drawing.strokes.size(), 2u);
    EXPECT_EQ(count(repaired, Mend::Kind::outlined), 1u);
}

TEST(Repair, LeavesNothingBrokenWhateverIsDrawn) {
    for (const auto& medium : media())
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            SCOPED_TRACE(std::string(medium.name) + " " + std::to_string(seed));
            const Drawing drawing = random_drawing(seed, 12 * static_cast<int>(seed));
            const Repaired repaired = repair(drawing, medium);
            EXPECT_EQ(hard_places(repaired.drawing, medium), 0u);
            EXPECT_EQ(repaired.broken_after, 0u);
            EXPECT_LE(repaired.kept, 1);
            EXPECT_GT(repaired.kept, 0);
            // Nothing stands where nothing was: bends go a millimetre, and joints bridge half a gap.
            const double farthest = 1.001 + (medium.gap / 2 + medium.line) / 2;
            for (const Stroke& stroke : repaired.drawing.strokes)
                for (const Point& p : stroke.points) EXPECT_LE(distance_to(drawing.strokes, p), farthest);
            // Mended once it needs no more.
            const Repaired again = repair(repaired.drawing, medium);
            EXPECT_EQ(again.broken_before, 0u);
            EXPECT_TRUE(same(repair(drawing, medium).drawing, repaired.drawing));
        }
}

// An arrow to the right that ends `gap` mm before a line, its head last.
Drawing arrow(double length, double gap) {
    Drawing drawing = blank();
    const double tip = 100 - gap - swell().line;
    drawing.strokes.push_back({{{100, 60}, {100, 140}}});
    drawing.strokes.push_back({{{tip - length, 100}, {tip, 100}}});
    drawing.strokes.push_back({{{tip - 6, 96}, {tip, 100}, {tip - 6, 104}}, false, LineClass::normal, 0, Role::arrow});
    return drawing;
}

TEST(Repair, HeadsOfArrowsGoBackFromWhatTheyNearlyTouch) {
    for (const double gap : {0.5, 1.0, 2.0}) {
        const Drawing drawing = arrow(60, gap);
        const Repaired repaired = repair(drawing, swell());
        ASSERT_EQ(repaired.drawing.strokes.size(), 3u) << gap;
        const auto& strokes = repaired.drawing.strokes;
        EXPECT_EQ(strokes[0].points.front().x, 100) << "what it points to stays";
        const Point tip = strokes[2].points[1];
        EXPECT_NEAR(100 - tip.x - swell().line, 3.25, 0.1);
        EXPECT_NEAR(strokes[1].points.back().x, tip.x, 0.02);
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(distance(strokes[2].points[i], tip), distance(drawing.strokes[2].points[i], drawing.strokes[2].points[1]),
                        0.02);
        EXPECT_EQ(count(repaired, Mend::Kind::shortened), 1u);
    }
    EXPECT_TRUE(repair(arrow(60, 4), swell()).changes.empty());
    EXPECT_TRUE(same(repair(arrow(60, -swell().line / 2), swell()).drawing, arrow(60, -swell().line / 2))) << "it touches";
    const double before = arrow(9, 1).strokes[2].points[1].x;
    const Drawing brief = repair(arrow(9, 1), swell()).drawing;
    for (const Stroke& stroke : brief.strokes)
        if (stroke.role == Role::arrow) {
            EXPECT_GE(stroke.points[1].x, before - 0.02) << "there is no room";
        }
}

// Towards a slanting line it takes more.
TEST(Repair, HeadsOfArrowsGoBackFromSlantingLinesToo) {
    Drawing drawing = arrow(60, 1);
    drawing.strokes[0].points = {{80, 140}, {120, 60}};
    const Repaired repaired = repair(drawing, swell());
    const Point tip = repaired.drawing.strokes.back().points[1];
    EXPECT_NEAR(distance_to({repaired.drawing.strokes[0]}, tip) - swell().line, 3.25, 0.15);
}

TEST(Repair, TellsThatAThicketIsNotFitToBeFelt) {
    const Repaired repaired = repair(random_drawing(7, 250), swell());
    EXPECT_LT(repaired.kept, kLegible);
    EXPECT_EQ(hard_places(repaired.drawing), 0u);
    EXPECT_EQ(repaired.changes.empty(), false);
    EXPECT_TRUE(std::is_sorted(repaired.changes.begin(), repaired.changes.end(),
                               [](const Mend& a, const Mend& b) { return a.at.y < b.at.y; }));
}

TEST(Repair, LeavesLinesThatStandAsTightAsTheGapAllows) {
    const Medium& medium = swell();
    const double pitch = width_of(LineClass::normal, medium) + medium.gap + 0.05;
    Drawing drawing = blank();
    for (double y = 0; y <= drawing.height; y += pitch) drawing.strokes.push_back({{{0, y}, {drawing.width, y}}});
    const Repaired repaired = repair(drawing, medium);
    EXPECT_TRUE(repaired.changes.empty());
    EXPECT_EQ(repaired.kept, 1);
}

// Three thousand lines across the page, every sixtieth of them strong; there is room for one in 56.
TEST(Repair, OfMoreLineThanHasRoomTheStrongestIsMended) {
    Drawing drawing = blank();
    for (int i = 0; i < 3000; ++i) {
        const double y = 0.083 * i;
        drawing.strokes.push_back({{{5, y}, {175, y}}, false, LineClass::normal, i % 60 == 7 ? 50.0F : 10.0F});
    }
    const Repaired repaired = repair(drawing, swell());
    EXPECT_EQ(hard_places(repaired.drawing), 0u);
    EXPECT_LT(repaired.kept, 0.05);
    const auto& strokes = repaired.drawing.strokes;
    EXPECT_EQ(std::count_if(strokes.begin(), strokes.end(), [](const Stroke& stroke) { return stroke.strength == 50; }), 50);
    EXPECT_EQ(count(repaired, Mend::Kind::left_out), 3000 - strokes.size());
    // One line that fills the page is not left out: then nothing would be there.
    Drawing one = blank();
    one.strokes.resize(2);
    for (const Stroke& stroke : drawing.strokes)
        one.strokes[0].points.insert(one.strokes[0].points.end(), stroke.points.begin(), stroke.points.end());
    one.strokes[1].points = {{5, 5}, {175, 5}};
    const Repaired filled = repair(one, swell());
    EXPECT_FALSE(filled.complete && filled.kept > kLegible);
    EXPECT_FALSE(filled.drawing.strokes.empty());
}

}  // namespace
}  // namespace tactics::repair_test
