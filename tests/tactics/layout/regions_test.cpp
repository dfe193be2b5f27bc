// SPDX-License-Identifier: Apache-2.0
// Regions go with the drawing, wherever it goes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tactics/geometry/box.h"
#include "tactics/geometry/region_place.h"
#include "tactics/layout/lay_out.h"
#include "tactics/repair/repair.h"
#include "tests/print/hard_pages.h"

namespace tactics::regions_test {
namespace {

using rendered::ring;
using rendered::sheet_of;

// A thing with a hole, drawn by its outlines; and one that is not drawn.
Drawing thing() {
    const std::vector<Point> outer = ring({60, 40}, 30, 40);
    std::vector<Point> inner = ring({60, 40}, 12, 40);
    Drawing drawing{180, 120, {{outer, true}, {inner, true}}, {}, {}};
    std::reverse(inner.begin(), inner.end());
    drawing.regions.push_back({"Ring", "Box/Ring", "seen from above", {{"kept", 1}}, {outer, inner}, {40, 40}});
    drawing.regions.push_back({"Pin", "Pin", "too small", {}, {}, {}});
    drawing.remarks.emplace_back("It is a test.");
    return drawing;
}

double area_of(const std::vector<Point>& ring) {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
        sum += (a.x * b.y - b.x * a.y) / 2;
    }
    return sum;
}

// The line that the region's first ring runs along is there, too.
void expect_along(const std::vector<Point>& ring, const std::vector<Point>& line) {
    ASSERT_EQ(ring.size(), line.size());
    for (std::size_t i = 0; i < ring.size(); ++i) EXPECT_LT(distance(ring[i], line[i]), 1e-9);
}

TEST(Regions, AHoleIsNotHeldAndShapesMayLieOverEachOther) {
    const Region one = thing().regions[0];
    EXPECT_TRUE(holds(one, {40, 40}));
    EXPECT_FALSE(holds(one, {60, 40}));
    EXPECT_FALSE(holds(one, {0, 0}));
    Region twice{"Two", "", "", {}, {{{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {{10, 0}, {30, 0}, {30, 20}, {10, 20}}}, {}};
    for (const double x : {5.0, 15.0, 25.0}) EXPECT_TRUE(holds(twice, {x, 10})) << x;
    EXPECT_TRUE(holds(one, place_in(one)));
    const Box box = box_of(twice);
    EXPECT_EQ(box.width(), 30);
    EXPECT_GT(box_of(Region{}).left, box_of(Region{}).right);
}

TEST(Regions, AreScaledAndLaidOutWithTheLines) {
    const Drawing half = scaled_to(thing(), 90);
    expect_along(half.regions[0].rings[0], half.strokes[0].points);
    EXPECT_TRUE(holds(half.regions[0], half.regions[0].at));
    for (const Orientation orientation : {Orientation::portrait, Orientation::landscape}) {
        Sheet sheet = sheet_of("a4", "Things");
        sheet.orientation = orientation;
        Page page = lay_out(thing(), sheet);
        ASSERT_EQ(page.regions.size(), 2u);
        expect_along(page.regions[0].rings[0], page.strokes[0].points);
        EXPECT_TRUE(holds(page.regions[0], page.regions[0].at));
        EXPECT_EQ(page.remarks, thing().remarks);
        move_by(page, 7, -3);
        expect_along(page.regions[0].rings[0], page.strokes[0].points);
        EXPECT_TRUE(holds(page.regions[0], page.regions[0].at));
    }
}

TEST(Regions, AreCutUpWithTheSheets) {
    Sheet sheet = sheet_of("a5", "Things");
    sheet.tiles = {2, 2};
    const Page whole = lay_out(thing(), sheet);
    const Pages pages = pages_of(thing(), sheet);
    double area = 0, all = 0;
    std::size_t told = 0;
    for (const auto& ring : whole.regions[0].rings) all += area_of(ring);
    for (const Page& page : pages.all)
        for (const Region& region : page.regions) {
            told += region.rings.empty() ? 1 : 0;
            for (const auto& ring : region.rings) {
                area += area_of(ring);
                for (const Point& at : ring) EXPECT_TRUE(at.x >= 0 && at.y >= 0 && at.x <= page.width && at.y <= page.height);
            }
            EXPECT_TRUE(region.rings.empty() || holds(region, region.at));
        }
    EXPECT_EQ(told, 1u) << "what is not drawn is told once";
    EXPECT_GE(std::abs(area), std::abs(all) * 0.999) << "what two sheets share is on both";
}

TEST(Regions, GoWithLinesThatAreBentApart) {
    const Medium& swell = find_medium("swell", "test");
    const double off = least_apart(swell, swell.line, swell.line) - 0.5;
    const std::vector<Point> square = {{20, 20}, {120, 20}, {120, 60}, {20, 60}};
    Drawing drawing{180, 120, {{square, true}, {{{20, 20 - off}, {120, 20 - off}}}}, {}, {}};
    drawing.regions.push_back({"Square", "", "", {}, {square}, {70, 40}});
    const Repaired mended = repair(drawing, swell);
    ASSERT_FALSE(mended.changes.empty());
    double moved = 0;
    for (const Point& corner : mended.drawing.regions[0].rings[0]) {
        double nearest = 1e9;
        for (const Stroke& stroke : mended.drawing.strokes)
            for (const Point& at : stroke.points) nearest = std::min(nearest, distance(at, corner));
        EXPECT_LT(nearest, 0.3);
        for (const Point& before : square) moved = std::max(moved, distance(before, corner) < 2 ? distance(before, corner) : 0);
    }
    EXPECT_GT(moved, 0.05) << "nothing was bent, so nothing is tested";
}

}  // namespace
}  // namespace tactics::regions_test
