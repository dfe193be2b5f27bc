// SPDX-License-Identifier: Apache-2.0
// What is seen of a model from its sides, and where it is cut.
#include "tactics/solid/views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tactics/geometry/box.h"
#include "tactics/geometry/distance.h"
#include "tactics/solid/seen_edges.h"
#include "tests/solid/models.h"

namespace tactics::views_test {
namespace {

using namespace tests;

std::vector<ModelPart> parts_in(const Model& model) {
    std::vector<Phrase> notes;
    return parts_of(model, {}, {}, notes);
}

double length_of(const SeenEdges& seen, LineClass line) {
    double length = 0;
    for (const DrawnSide& side : merged(seen.edges, 1e-3)) length += side.line == line ? distance(side.from, side.to) : 0;
    return length;
}

FoldOut views(const Model& model, double width = 190, double height = 270, const FoldWish& wish = {}) {
    std::vector<Phrase> notes;
    return views_of(model, width, height, find_medium("swell", "test"), wish, notes);
}

TEST(SeenEdges, ABoxIsItsOutline) {
    Model model;
    add_box(model, "Box", -1, {0, 0, 50}, {100, 60, 100});
    for (const auto& [view, perimeter] : {std::pair{kFromAbove, 320.0}, {kFromTheFront, 400.0}, {kFromTheSide, 320.0}}) {
        const SeenEdges seen = seen_edges(parts_in(model), view, 0.01);
        EXPECT_NEAR(length_of(seen, LineClass::thick), perimeter, 0.1);
        EXPECT_NEAR(length_of(seen, LineClass::thin) + length_of(seen, LineClass::normal), 0, 0.1);
    }
}

TEST(Views, WhatIsTooSmallIsToldToBeSmallWhereNothingIsDrawn) {
    Model model;
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j) add_box(model, "Grain", -1, {100.0 * i, 100.0 * j, 1.5}, {3, 3, 3});
    for (const FoldedObject& one : views(model).objects) EXPECT_EQ(one.fate, FoldedObject::Fate::small);
}

TEST(SeenEdges, WhatIsNearerHidesWhatIsFarther) {
    Model model;
    add_box(model, "Wall", -1, {0, 0, 50}, {100, 10, 100});
    add_box(model, "Behind", -1, {0, 50, 20}, {40, 10, 40});
    add_box(model, "Beside", -1, {60, 50, 20}, {40, 10, 40});  // half of it behind
    add_box(model, "Before", -1, {0, -50, 20}, {20, 10, 40});
    const SeenEdges seen = seen_edges(parts_in(model), kFromTheFront, 0.01);
    std::map<std::uint32_t, double> length;
    for (std::size_t i = 0; i < seen.edges.size(); ++i) length[seen.part[i]] += distance(seen.edges[i].from, seen.edges[i].to);
    EXPECT_GT(length[0], 0);
    EXPECT_NEAR(length[1], 40, 1) << "its lower side only, which is where that of the wall is";
    EXPECT_NEAR(length[2], 30 + 40 + 40, 1);
    EXPECT_NEAR(length[3], 120, 1);
}

TEST(SeenEdges, ACylinderHasNoFacets) {
    Model model;
    add_cylinder(model, "Can", -1, {0, 0, 50}, 30, 100);
    const SeenEdges front = seen_edges(parts_in(model), kFromTheFront, 0.01);
    EXPECT_NEAR(length_of(front, LineClass::thick), 2 * (60 + 100), 4);
    EXPECT_NEAR(length_of(front, LineClass::thin), 0, 0.1);
}

TEST(CutSides, AClosedSolidGivesClosedRingsOfTheRightArea) {
    Model model;
    add_box(model, "Box", -1, {0, 0, 50}, {100, 60, 100});
    add_cylinder(model, "Can", -1, {200, 0, 50}, 30, 100);
    const std::vector<ModelPart> parts = parts_in(model);
    const double expected[] = {100 * 100, 60 * 100};
    for (std::size_t part = 0; part < parts.size(); ++part) {
        const std::vector<DrawnSide> sides = cut_sides(parts[part], kFromTheFront, 0);
        double area = 0;
        for (const DrawnSide& side : sides) {
            area += (side.from.x * side.to.y - side.to.x * side.from.y) / 2;
            EXPECT_EQ(std::count_if(sides.begin(), sides.end(),
                                    [&](const DrawnSide& other) { return distance(other.from, side.to) < 1e-6; }),
                      1)
                << "a ring goes on from each place, once";
        }
        EXPECT_NEAR(std::abs(area), expected[part], 0.02 * expected[part]);
    }
    EXPECT_TRUE(cut_sides(parts[0], kFromTheFront, 31).empty());
    // Along a side of the box: all of it or nothing, never a part.
    for (const double at : {-30.0, 30.0}) EXPECT_NE(cut_sides(parts[0], kFromTheFront, at).size() % 4, 1u);
}

TEST(Views, FourOfThemHaveTheirTitles) {
    const FoldOut made = views(table(1200));
    std::multiset<std::string> names;
    for (const Name& name : made.drawing.names) names.insert(name.text);
    for (const char* title : {"top", "front", "side", "section"}) EXPECT_EQ(names.count(title), 1u) << title;
    EXPECT_EQ(names.count("Top"), 1u) << "an object is named once";
    EXPECT_LE(made.drawing.width, 190 + 1e-6);
    EXPECT_LE(made.drawing.height, 270 + 1e-6);
}

TEST(Views, NoTwoLinesAreNearerThanTheMediumWantsUnlessTheyMeet) {
    Model model = table(1200);
    for (int i = 0; i < 40; ++i) add_box(model, "Book", -1, {-400.0 + 20 * i, 0, 740.0 + 100 + i}, {17, 200, 200.0 + 2 * i});
    const Medium& medium = find_medium("swell", "test");
    const FoldOut made = views(model);
    const double apart = least_apart(medium, medium.line, medium.line);
    EXPECT_GT(made.drawing.strokes.size(), 8u);
    std::size_t near = 0;
    for (const Stroke& one : made.drawing.strokes)
        for (const Stroke& other : made.drawing.strokes) {
            if (&one == &other) continue;
            // Where the middle of a side of one comes near to the other.
            for (std::size_t i = 0; i + 1 < one.points.size(); ++i) {
                const Point a = one.points[i], b = one.points[i + 1], middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
                if (distance(a, b) < 4 * apart) continue;
                for (std::size_t k = 0; k + 1 < other.points.size(); ++k) {
                    const double off = distance_to_segment(middle, other.points[k], other.points[k + 1]);
                    near += off < apart * 0.99 && off > 0.3 ? 1 : 0;
                }
            }
        }
    EXPECT_EQ(near, 0u);
}

TEST(Views, EveryObjectHasItsRegionWhereItIsDrawnOrItIsTold) {
    Model model = table(1200);
    add_box(model, "Pin", -1, {0, 0, 745}, {1, 1, 2});
    const FoldOut made = views(model);
    std::set<std::string> drawn, told;
    for (const Region& region : made.drawing.regions) {
        (region.rings.empty() ? told : drawn).insert(region.path);
        EXPECT_TRUE(region.rings.empty() || holds(region, region.at)) << region.name.english();
    }
    for (const FoldedObject& one : made.objects) {
        const bool is_drawn = one.fate == FoldedObject::Fate::drawn;
        EXPECT_EQ(drawn.contains(one.path), is_drawn) << one.path;
        EXPECT_TRUE(is_drawn || told.contains(one.path)) << one.path;
    }
    EXPECT_TRUE(told.contains("Pin"));
    EXPECT_TRUE(drawn.contains("Table/Top"));
}

// Of a cone that is cut along its axis, facets are cut at a place.
TEST(Views, SidesOfNoLengthAreNoLines) {
    Model model;
    add_object(model, "Cone", -1);
    const Point3 tip{0, 0, 100};
    std::vector<Point3> base;
    for (int i = 0; i < 24; ++i) base.push_back({50 * std::cos(i * 0.2618), 50 * std::sin(i * 0.2618), 0});
    for (std::size_t i = 0; i < base.size(); ++i) add_face(model, {base[i], base[(i + 1) % base.size()], tip});
    add_face(model, {base.rbegin(), base.rend()});
    for (const Stroke& stroke : views(model).drawing.strokes)
        for (const Point& at : stroke.points) EXPECT_TRUE(std::abs(at.x) < 200 && std::abs(at.y) < 300);
}

TEST(Views, TheSectionIsWhereItIsAskedFor) {
    Model model;
    add_box(model, "Front", -1, {0, -100, 50}, {100, 50, 100});
    add_box(model, "Back", -1, {0, 100, 25}, {60, 50, 50});
    FoldWish wish;
    wish.section = 0.1;
    const auto cut = [&](const FoldOut& made) {
        std::set<std::string> names;
        for (const Region& region : made.drawing.regions)
            if (region.description.english().find("section") != std::string::npos) names.insert(region.name.english());
        return names;
    };
    EXPECT_EQ(cut(views(model, 190, 270, wish)), std::set<std::string>{"Front"});
    wish.section = 0.9;
    EXPECT_EQ(cut(views(model, 190, 270, wish)), std::set<std::string>{"Back"});
    EXPECT_EQ(cut(views(model)).size(), 1u) << "the middle cuts nothing";
}

}  // namespace
}  // namespace tactics::views_test
