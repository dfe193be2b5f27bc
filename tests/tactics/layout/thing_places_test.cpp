// SPDX-License-Identifier: Apache-2.0
// Places of things for their names: on their own border, never on one that a neighbour shares.
#include "tactics/layout/thing_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tactics/layout/lay_out.h"

namespace tactics::thing_places_test {
namespace {

Region box(const std::string& name, double left, double top, double width, double height) {
    Region region;
    region.name = name;
    region.rings = {{{left, top}, {left + width, top}, {left + width, top + height}, {left, top + height}}};
    region.at = {left + width / 2, top + height / 2};
    return region;
}

double to_side(Point p, Point a, Point b) {
    const double square = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
    const double t = std::clamp(((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / square, 0.0, 1.0);
    return distance(p, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
}

double to_border(Point p, const Region& region) {
    double least = 1e9;
    for (const auto& ring : region.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) least = std::min(least, to_side(p, ring[i], ring[(i + 1) % ring.size()]));
    return least;
}

TEST(ThingPlaces, LieOnTheBorderThatNoNeighbourShares) {
    const std::vector<Region> regions = {box("left", 10, 10, 40, 30), box("right", 50, 10, 40, 30)};
    const ThingPlaces things(regions);
    const auto places = things.on_border(regions[0], {30, 25}, ThingPlaces::Border::own, 100);
    ASSERT_GE(places.size(), 3u);
    for (const Point& at : places) {
        EXPECT_LT(to_border(at, regions[0]), 1e-9);
        EXPECT_GE(to_border(at, regions[1]), 1) << at.x << ' ' << at.y;
    }
    const auto all = things.on_border(regions[0], {30, 25}, ThingPlaces::Border::any, 100);
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](Point at) { return to_border(at, regions[1]) < 1e-9; }));
}

TEST(ThingPlaces, WhatLiesOnSomethingHasABorderOfItsOwn) {
    const std::vector<Region> regions = {box("table", 10, 10, 100, 80), box("plate", 40, 40, 20, 20)};
    const ThingPlaces things(regions);
    EXPECT_GE(things.on_border(regions[1], {50, 50}, ThingPlaces::Border::own, 100).size(), 4u);
    // Words on the table beside the plate may name the plate; words on the plate do not name the table.
    EXPECT_TRUE(things.is_free_of_others(regions[1], {30, 50}));
    EXPECT_FALSE(things.is_free_of_others(regions[0], {50, 50}));
}

TEST(ThingPlaces, BelongToTheThingThatHasTheNameNotToWhatLiesOnIt) {
    const std::vector<Region> regions = {box("cup", 20, 20, 30, 30),   box("leg", 100, 20, 20, 20),
                                         box("board", 10, 10, 70, 70), box("leg", 100, 60, 20, 20),
                                         box("leg", 96, 56, 40, 40),   box("cup: bottom", 20, 60, 10, 10)};
    const ThingPlaces things(regions);
    EXPECT_EQ(things.thing_of("board", {35, 35}), &regions[2]);
    EXPECT_EQ(things.thing_of("cup", {35, 35}), &regions[0]);
    EXPECT_EQ(things.thing_of("sticker", {35, 35}), nullptr);
    // Of several that which holds the place, the smallest; else the nearest, as files round places on a border.
    EXPECT_EQ(things.thing_of("leg", {110, 30}), &regions[1]);
    EXPECT_EQ(things.thing_of("leg", {110, 70}), &regions[3]);
    EXPECT_EQ(things.thing_of("leg", {130, 90}), &regions[4]);
    EXPECT_EQ(things.thing_of("leg", {110, 40.01}), &regions[1]);
    EXPECT_EQ(things.thing_of("leg", {110, 54}), &regions[4]);
    EXPECT_EQ(things.thing_of("cup", {75, 75}), nullptr);
    EXPECT_EQ(things.thing_of("bottom", {25, 65}), &regions[5]);
    EXPECT_EQ(things.thing_of("bottom", {110, 30}), nullptr);
}

TEST(ThingPlaces, AreTheNearestOnesFirst) {
    const std::vector<Region> regions = {box("long", 10, 10, 150, 12)};
    const ThingPlaces things(regions);
    const auto places = things.on_border(regions[0], {20, 16}, ThingPlaces::Border::own, 8);
    ASSERT_EQ(places.size(), 8u);
    for (std::size_t i = 1; i < places.size(); ++i)
        EXPECT_GE(distance(places[i], {20, 16}), distance(places[i - 1], {20, 16}) - 0.05 * 150);
    EXPECT_LE(distance(places[0], {20, 16}), 12);
}

// Steps of different length that are too narrow for words, each with a neighbour above and below it.
Drawing steps(int count, double high) {
    Drawing drawing;
    drawing.width = 150;
    drawing.height = count * high;
    for (int i = 0; i < count; ++i) {
        const double in = 3.0 * i;
        const Region region = box("step " + std::to_string(i + 1), in, i * high, 150 - 2 * in, high);
        drawing.strokes.push_back({region.rings[0], true});
        drawing.names.push_back({region.at, "step " + std::to_string(i + 1), "test", 0, true});
        drawing.regions.push_back(region);
    }
    return drawing;
}

TEST(ThingPlaces, NarrowNeighboursHaveTheirNamesAtTheirEndsAndNoLineIsCrossed) {
    Sheet sheet;
    sheet.paper = find_paper("a4", "test");
    sheet.medium = &find_medium("swell", "test");
    sheet.drawing_width = 150;
    for (const int count : {4, 8, 12}) {
        SCOPED_TRACE(count);
        const Page page = lay_out(steps(count, 9), sheet);
        EXPECT_TRUE(page.left_out.empty());
        ASSERT_EQ(page.names.size(), static_cast<std::size_t>(count));
        for (const PageName& name : page.names) {
            EXPECT_EQ(name.key, "") << name.text;
            for (const Region& region : page.regions) {
                if (region.name.english() == name.text) continue;
                EXPECT_GE(to_border(name.thing, region), 1) << name.text;
            }
        }
        for (const PageStroke& lead : page.strokes) {
            if (lead.role != Role::lead) continue;
            // From outside all steps to the border of one.
            for (const Region& region : page.regions)
                for (double t = 0; t < 0.95; t += 0.05)
                    EXPECT_FALSE(holds(region, {lead.points[0].x + t * (lead.points[1].x - lead.points[0].x),
                                                lead.points[0].y + t * (lead.points[1].y - lead.points[0].y)}));
        }
    }
}

}  // namespace
}  // namespace tactics::thing_places_test
