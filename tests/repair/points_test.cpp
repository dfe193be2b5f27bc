// SPDX-License-Identifier: Apache-2.0
// Points of a chart that are too small or too close to each other for a finger.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tactics/layout/lay_out.h"
#include "tactics/repair/repair.h"
#include "tactics/rules/rule.h"

namespace tactics::points_test {
namespace {

const Medium& swell() { return find_medium("swell", "test"); }

Drawing blank() {
    Drawing drawing;
    drawing.width = 180;
    drawing.height = 250;
    return drawing;
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

std::size_t count(const Repaired& repaired, Mend::Kind kind) {
    return static_cast<std::size_t>(
        std::count_if(repaired.changes.begin(), repaired.changes.end(), [kind](const Mend& mend) { return mend.kind == kind; }));
}

// Told by the rules themselves, on the page that would be printed.
std::size_t hard_places(const Drawing& drawing) {
    Sheet sheet;
    sheet.paper = {"", "", drawing.width, drawing.height};
    sheet.medium = &swell();
    sheet.bare = true;
    sheet.margin = 0;
    std::size_t places = 0;
    for (const Verdict& verdict : check_page(lay_out(drawing, sheet), demands_of(swell())))
        if (verdict.demand.rule->hard) places += verdict.findings.places.size();
    return places;
}

// Beside a line that all of them are too close to: what can go away goes, what is nearer joins it, and the line stays whole.
TEST(Points, BesideALineGoAwayFromItOrOntoIt) {
    Drawing drawing = blank();
    drawing.strokes.push_back({{{20, 100}, {160, 100}}, false, LineClass::normal, 0, Role::line});
    std::vector<Point> middles;
    for (int i = 0; i < 6; ++i) middles.push_back({35 + 20.0 * i, 100 + 2 + (i % 2 == 0 ? 1.2 : 3.0)});
    drawing.areas = discs_at(middles, 2);
    for (Area& area : drawing.areas) area.role = Role::symbol;
    const Repaired repaired = repair(drawing, swell());
    EXPECT_EQ(hard_places(repaired.drawing), 0u);
    ASSERT_EQ(repaired.drawing.areas.size(), middles.size());
    EXPECT_EQ(repaired.drawing.strokes.size(), 1u);
    EXPECT_NEAR(repaired.kept, 1, 1e-9);
    for (std::size_t i = 0; i < middles.size(); ++i) EXPECT_LE(distance(middle_of(repaired.drawing.areas[i]), middles[i]), 1.02);
}

// Rows of a dot plot, beside each other without a gap and 1 mm below each other.
TEST(Points, ThatTouchBecomeSmallerAlike) {
    Drawing drawing = blank();
    std::vector<Point> middles;
    for (int row = 0; row < 4; ++row)
        for (int i = 0; i < 3; ++i) middles.push_back({40 + 7.98 * i, 40 + 9.0 * row});
    drawing.areas = discs_at(middles, 4);
    const Repaired repaired = repair(drawing, swell());
    EXPECT_EQ(hard_places(repaired.drawing), 0u);
    ASSERT_EQ(repaired.drawing.areas.size(), middles.size());
    EXPECT_EQ(count(repaired, Mend::Kind::shrunk), middles.size());
    EXPECT_EQ(repaired.kept, 1);
    for (std::size_t i = 0; i < middles.size(); ++i) {
        const std::vector<Point>& ring = repaired.drawing.areas[i].rings[0];
        const double across = distance(ring[0], ring[12]);
        EXPECT_NEAR(across, distance(repaired.drawing.areas[0].rings[0][0], repaired.drawing.areas[0].rings[0][12]), 0.03);
        EXPECT_GE(across, 2);
        EXPECT_LE(distance(middle_of(repaired.drawing.areas[i]), middles[i]), 1.02);
    }
}

// Rows of points that touch, and something else.
Repaired with_rows(const std::vector<Area>& more, const std::vector<Stroke>& lines = {}) {
    Drawing drawing = blank();
    drawing.areas = discs_at({{40, 40}, {47.98, 40}, {55.96, 40}, {40, 49}, {47.98, 49}, {55.96, 49}}, 4);
    drawing.areas.insert(drawing.areas.end(), more.begin(), more.end());
    drawing.strokes = lines;
    return repair(drawing, swell());
}

TEST(Points, KeepTheirSizeWhereItTellsSomethingOrLinesEndOnThem) {
    EXPECT_GT(count(with_rows({}), Mend::Kind::shrunk), 0u);
    EXPECT_EQ(count(with_rows(discs_at({{100, 100}}, 3)), Mend::Kind::shrunk), 0u) << "a smaller value";
    EXPECT_EQ(count(with_rows({}, {{{{40, 36}, {40, 10}}}}), Mend::Kind::shrunk), 0u) << "the stem of a note";
    Drawing beak = blank();
    beak.areas = discs_at({{40, 40}, {45.9, 40}}, 2.8);
    EXPECT_EQ(count(repair(beak, swell()), Mend::Kind::shrunk), 0u) << "parts of a thing";
}

TEST(Points, SpecksBecomeAsLargeAsABrailleDotIfAllHaveRoom) {
    Drawing drawing = blank();
    drawing.areas = discs_at({{20, 20}, {60, 20}, {100, 20}}, 0.5);
    const Repaired repaired = repair(drawing, swell());
    EXPECT_EQ(hard_places(repaired.drawing), 0u);
    EXPECT_EQ(count(repaired, Mend::Kind::enlarged), 3u);
    for (const Area& speck : repaired.drawing.areas) EXPECT_NEAR(distance(speck.rings[0][0], speck.rings[0][12]), 1.6, 0.03);
    EXPECT_EQ(count(repair(drawing, find_medium("embosser", "test")), Mend::Kind::enlarged), 0u) << "a dot is a dot";
    for (const Point more : {Point{104.3, 20}, Point{0.5, 100}}) {  // 3.3 mm apart; at the border
        Drawing full = drawing;
        full.areas.push_back(discs_at({more}, 0.5)[0]);
        EXPECT_EQ(count(repair(full, swell()), Mend::Kind::enlarged), 0u);
    }
}

}  // namespace
}  // namespace tactics::points_test
