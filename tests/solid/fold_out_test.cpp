// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/fold_out.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <random>

#include "tactics/error.h"
#include "tactics/solid/drawn_lines.h"
#include "tactics/solid/fold_options.h"
#include "tests/solid/folded.h"
#include "tests/solid/models.h"

namespace tactics::fold_out_test {
namespace {

using namespace tests;

TEST(FoldOut, ACubeIsACrossOfFiveAndWithItsBottomOfSix) {
    Model cube;
    add_box(cube, "Cube", -1, {0, 0, 50}, {100, 100, 100});
    const Folded five = folded(cube), six = folded(cube, kFromAbove, false);
    EXPECT_EQ(five.layout.panels.size(), 5u);
    EXPECT_EQ(six.layout.panels.size(), 6u);
    // The sides hang on the top, the bottom on one of them.
    std::map<int, int> folds;
    for (const PlacedPanel& placed : six.layout.panels) ++folds[placed.folds];
    EXPECT_EQ(folds, (std::map<int, int>{{0, 1}, {1, 4}, {2, 1}}));
    for (const Folded* made : {&five, &six}) {
        expect_true_shapes(*made);
        expect_no_overlap(*made);
    }
}

TEST(FoldOut, ASideThatIsShownTwiceIsDashed) {
    Model cube;
    add_box(cube, "Cube", -1, {0, 0, 50}, {100, 100, 100});
    const Folded made = folded(cube);
    double dashed = 0, whole = 0;
    for (const Stroke& stroke : lines_of(made.layout, made.parts, made.panels, made.thing).strokes)
        (stroke.role == Role::dash ? dashed : whole) += length_of(stroke);
    // Four upright edges twice; those of the top and of the bottom once.
    EXPECT_NEAR(dashed, 800, 1e-6);
    EXPECT_NEAR(whole, 800, 1e-6);
}

TEST(FoldOut, ATableHasItsLegsOutwardFromItsCorners) {
    for (const double length : {800.0, 2400.0}) {
        const Folded made = folded(table(length));
        ASSERT_EQ(made.layout.panels.size(), 1u);
        ASSERT_EQ(made.layout.bars.size(), 4u);
        const FlatShape& top = made.layout.panels.front().shape;
        for (const PlacedBar& leg : made.layout.bars) {
            EXPECT_EQ(leg.handling, Handling::flattened);
            EXPECT_NEAR(distance(leg.from, leg.to), 700, 1e-6);
            EXPECT_LT(distance_to_border(top, leg.from), 1e-6);
            EXPECT_FALSE(holds(top, leg.to));
            // Along the bisector of a square corner; near to its longest direction for a long table.
            const double dx = std::abs(leg.to.x - leg.from.x), dy = std::abs(leg.to.y - leg.from.y);
            EXPECT_NEAR(dy / dx, 800 / length, 1e-6);
        }
    }
}

// Fig. 4 of the paper: with things beside it the legs of a table lie across it, with things on it outward.
TEST(FoldOut, LegsLieWhereThereIsRoom) {
    Model crowded = table(2400);
    for (const int x : {-1, 1}) add_box(crowded, "Wall", -1, {x * 1310.0, 0, 500}, {200, 3000, 1000});
    for (const int y : {-1, 1}) add_box(crowded, "Wall", -1, {0, y * 510.0, 500}, {2400, 200, 1000});
    const Folded made = folded(crowded);
    for (const PlacedBar& leg : made.layout.bars) {
        if (leg.handling == Handling::wedge) continue;
        EXPECT_LT(std::abs(leg.to.x), std::abs(leg.from.x));
    }
}

TEST(FoldOut, AStoveBetweenCupboardsShowsItsTopAndItsFront) {
    Model row;
    add_box(row, "Back wall", -1, {0, 310, 1000}, {3000, 20, 2000});
    for (const int i : {-1, 0, 1}) add_box(row, i == 0 ? "Stove" : "Cupboard", -1, {i * 600.0, 0, 425}, {600, 600, 850});
    const Folded made = folded(row);
    int stove = 0;
    for (const Panel& panel : made.panels.panels)
        if (made.parts[panel.part].object == 2 && panel.reached) {
            ++stove;
            EXPECT_TRUE(panel.normal.z > 0.9 || panel.normal.y < -0.9);
        }
    EXPECT_EQ(stove, 2);
    int shown = 0;
    for (const PlacedPanel& placed : made.layout.panels) shown += made.parts[made.panels.panels[placed.panel].part].object == 2;
    EXPECT_EQ(shown, 2);
}

// Its corners are a millimetre off one plane, which is nothing in twenty metres: the face does not lie on itself.
TEST(FoldOut, ABentFaceIsReached) {
    Model hall;
    add_box(hall, "Hall", -1, {0, 0, 2500}, {20000, 12000, 5000});
    for (Point3& at : hall.vertices)
        if (at.z > 4000 && at.x * at.y > 0) at.z += 1.5;
    const Folded made = folded(hall);
    int reached = 0;
    for (const Panel& panel : made.panels.panels) reached += panel.reached;
    EXPECT_EQ(reached, 5);
    EXPECT_EQ(made.layout.panels.size(), 5u);
}

TEST(FoldOut, APyramidOnItsBaseOpensAsAStar) {
    Model model;
    add_object(model, "Pyramid");
    const Point3 a{-50, -50, 0}, b{50, -50, 0}, c{50, 50, 0}, d{-50, 50, 0}, tip{0, 0, 80};
    add_face(model, {a, d, c, b});
    add_face(model, {a, b, tip});
    add_face(model, {b, c, tip});
    add_face(model, {c, d, tip});
    add_face(model, {d, a, tip});
    const Folded made = folded(model);
    EXPECT_EQ(folded_ones(made), 4u);
    expect_true_shapes(made);
    expect_no_overlap(made);
}

// Vertices that tremble by a millionth, faces in another order, centimetres for metres, and triangles for squares.
TEST(FoldOut, IsTheSameHoweverTheModelIsWritten) {
    Model plain;
    add_box(plain, "Cupboard", -1, {0, 0, 400}, {600, 500, 800});
    add_box(plain, "Table", -1, {1500, 200, 350}, {900, 700, 700});
    const auto drawn = [](const Model& model) {
        std::vector<Phrase> notes;
        FoldOut made = fold_out(model, 170, 240, find_medium("swell", ""), {}, notes);
        return made.drawing;
    };
    const Drawing first = drawn(plain);
    const auto expect_same = [&](const Model& model) {
        const Drawing other = drawn(model);
        EXPECT_NEAR(first.width, other.width, 1e-2);
        ASSERT_EQ(first.strokes.size(), other.strokes.size());
        EXPECT_NEAR(total_stroke_length(first), total_stroke_length(other), 0.1);
    };
    Model trembling = plain;
    std::mt19937 chance(1);
    for (Point3& at : trembling.vertices) {
        const auto by = [&] { return 1e-6 * 1500 * (static_cast<double>(chance()) / 4294967295.0 - 0.5); };
        at = at + Point3{by(), by(), by()};
    }
    expect_same(trembling);
    Model reordered = plain;
    for (ModelObject& object : reordered.objects)
        std::reverse(reordered.faces.begin() + object.first, reordered.faces.begin() + object.first + object.count);
    expect_same(reordered);
    Model small = plain;
    for (Point3& at : small.vertices) at = 0.01 * at;
    std::vector<Phrase> notes;
    FoldWish wish;
    wish.reach.hand = 0.5;
    EXPECT_EQ(fold_out(small, 170, 240, find_medium("swell", ""), wish, notes).drawing.strokes.size(), first.strokes.size());
    // Squares cut into triangles, one of them with a corner on a neighbour's side.
    Model cut;
    for (const ModelObject& object : plain.objects) {
        add_object(cut, object.name);
        for (std::uint32_t f = object.first; f < object.first + object.count; ++f) {
            const auto at = [&](std::uint32_t i) { return plain.vertices[plain.corners[plain.faces[f].first + i]]; };
            if (f == object.first + 1) {
                const Point3 half = 0.5 * (at(0) + at(1));
                add_face(cut, {at(0), half, at(3)});
                add_face(cut, {half, at(1), at(2)});
                add_face(cut, {half, at(2), at(3)});
            } else {
                add_face(cut, {at(0), at(1), at(2)});
                add_face(cut, {at(0), at(2), at(3)});
            }
        }
    }
    expect_same(cut);
}

TEST(FoldOut, EveryObjectIsDrawnOrTold) {
    Model model = table(1200);
    add_cylinder(model, "Bottle", -1, {100, 0, 840}, 40, 200);
    add_box(model, "Crumb", -1, {-300, 100, 741}, {2, 2, 2});
    add_box(model, "Box", -1, {-300, -100, 790}, {200, 120, 100});
    std::vector<Phrase> notes;
    const FoldOut made = fold_out(model, 170, 240, find_medium("swell", ""), {}, notes);
    std::map<std::string, FoldedObject::Fate> fate;
    for (const FoldedObject& one : made.objects) fate[one.path] = one.fate;
    EXPECT_EQ(fate.size(), 5u);  // four legs of one name
    EXPECT_EQ(fate["Crumb"], FoldedObject::Fate::small);
    for (const char* name : {"Table/Top", "Table/Leg", "Bottle", "Box"}) EXPECT_EQ(fate[name], FoldedObject::Fate::drawn) << name;
    for (const FoldedObject& one : made.objects) {
        if (one.fate != FoldedObject::Fate::drawn) continue;
        EXPECT_TRUE(std::any_of(made.drawing.names.begin(), made.drawing.names.end(),
                                [&](const Name& name) { return name.text == one.name && distance(name.at, one.at) < 1e-9; }));
        EXPECT_GE(one.at.x, 0);
        EXPECT_LE(one.at.x, made.drawing.width);
    }
    // A part alone is larger, and what was too small may be there again.
    FoldWish wish;
    wish.part = "Crumb";
    EXPECT_EQ(fold_out(model, 170, 240, find_medium("swell", ""), wish, notes).objects.front().fate, FoldedObject::Fate::drawn);
    wish.part = "Tbale";
    try {
        fold_out(model, 170, 240, find_medium("swell", ""), wish, notes);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("Table"), std::string::npos) << error.what();
    }
}

// What is said of a thing and what a finger finds at its place.
TEST(FoldOut, EveryPlaceThatIsToldLiesInARegionOfItsObject) {
    Model scene = table(1200);
    add_cylinder(scene, "Bottle", -1, {100, 0, 840}, 40, 200);
    add_turned(scene, "Pot", {-300, 0, 740}, {{0, 0}, {90, 0}, {90, 120}}, 24);
    add_box(scene, "Box", -1, {-300, -250, 790}, {200, 120, 100});
    add_box(scene, "Rod", -1, {450, 0, 940}, {10, 10, 400});
    for (const FoldPlane plane : {FoldPlane::above, FoldPlane::front, FoldPlane::side}) {
        std::vector<Phrase> notes;
        const FoldOut made = fold_out(scene, 170, 240, find_medium("swell", ""), {.plane = plane}, notes);
        int wedges = 0;
        for (const FoldedObject& one : made.objects) {
            const auto holding = [&](Point at) {
                return std::count_if(made.drawing.regions.begin(), made.drawing.regions.end(), [&](const Region& region) {
                    return region.path == one.path && !region.rings.empty() && holds(region, at);
                });
            };
            if (one.fate != FoldedObject::Fate::drawn) {
                EXPECT_EQ(holding(one.at), 0) << one.path;
                continue;
            }
            EXPECT_GE(holding(one.at), 1) << one.path << ' ' << name_of(plane);
            for (const auto& end : {one.opening, one.bottom})
                if (end) {
                    EXPECT_GE(holding(*end), 1) << one.path;
                }
            wedges += one.wedges;
        }
        EXPECT_EQ(static_cast<int>(made.drawing.areas.size()), wedges);
        // A wedge is within the region of its bar.
        for (const Area& area : made.drawing.areas)
            for (const Point& corner : area.rings.front())
                EXPECT_TRUE(std::any_of(made.drawing.regions.begin(), made.drawing.regions.end(), [&](const Region& region) {
                    return !region.rings.empty() &&
                           holds(region, {corner.x, corner.y + (corner.y > area.rings.front()[0].y ? -0.1 : 0.1)});
                }));
    }
}

TEST(FoldOut, AVesselHasAnOpeningAndNoLid) {
    Model model;
    add_cylinder(model, "Pot", -1, {0, 0, 60}, 80, 120, true);
    const Folded made = folded(model);
    const bool opening = std::any_of(made.layout.panels.begin(), made.layout.panels.end(), [&](const PlacedPanel& one) {
        return made.panels.panels[one.panel].kind == PanelKind::opening;
    });
    EXPECT_TRUE(opening);
    // From the side it is a U: two walls and a bottom, and no line where it is open. Its bottom is a second circle, dashed.
    double length = 0, dashed = 0;
    for (const Stroke& stroke : lines_of(made.layout, made.parts, made.panels, made.thing).strokes)
        (stroke.role == Role::dash ? dashed : length) += length_of(stroke);
    EXPECT_NEAR(length, 2 * std::numbers::pi * 80 + 2 * 120 + 160, 2);
    EXPECT_NEAR(dashed, 2 * std::numbers::pi * 80, 1);
}

TEST(FoldOut, ARodTowardsTheReaderHasTheScaleOfItsLength) {
    Model model;
    add_box(model, "Rod", -1, {0, 0, 500}, {20, 20, 1000});
    FoldWish wish;
    wish.plane = FoldPlane::above;
    std::vector<Phrase> notes;
    const FoldOut made = fold_out(model, 170, 240, find_medium("swell", ""), wish, notes);
    EXPECT_LE(made.scale, 0.17);
    EXPECT_GE(made.scale, 0.1);
}

// Three tines of a block come near the side of the plate that it lies on; between them the side is there to be felt.
TEST(FoldOut, ALineIsOneWithABorderOnlyWhereThatIsNear) {
    Model model;
    const int all = add_group(model, "Plate with a comb");
    add_box(model, "Plate", all, {0, 0, 5}, {200, 100, 10});
    for (const double x : {-90.0, 0.0, 90.0}) add_box(model, "Tine", all, {x, -24.7, 20}, {20, 50, 20});
    const Folded made = folded(model);
    double front = 0;
    for (const Stroke& stroke : lines_of(made.layout, made.parts, made.panels, made.thing, 1).strokes)
        for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i)
            if (std::abs(stroke.points[i].y - 50) < 1e-6 && std::abs(stroke.points[i + 1].y - 50) < 1e-6)
                front += distance(stroke.points[i], stroke.points[i + 1]);
    EXPECT_GE(front, 130);
}

TEST(FoldOut, ObjectsAndReadersHaveTheirOwnSettings) {
    Model model;
    add_box(model, "Left", -1, {0, 0, 50}, {100, 100, 100});
    add_box(model, "Right", -1, {1000, 0, 50}, {100, 100, 100});
    FoldWish wish;
    Settings settings(fold_options());
    settings.set("fold", "no", "", "");
    take_settings(wish, settings, "Left", "");
    std::vector<Phrase> notes;
    const FoldOut made = fold_out(model, 170, 240, find_medium("swell", ""), wish, notes);
    EXPECT_EQ(made.objects[0].folded, 0);
    EXPECT_GE(made.objects[1].folded, 3);
    Settings reader(fold_options());
    reader.set("cost-fold", "1", "", "");
    FoldWish plain;
    take_settings(plain, reader, "", "");
    for (const FoldedObject& one : fold_out(model, 170, 240, find_medium("swell", ""), plain, notes).objects)
        EXPECT_EQ(one.folded, 0);
    EXPECT_THROW(take_settings(wish, reader, "Left", ""), Error);
}

TEST(FoldOut, BadFacesAreLeftOutAndTold) {
    Model model;
    add_object(model, "Broken");
    add_face(model, {{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}});
    add_face(model, {{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}});
    add_face(model, {{0, 0, 0}, {50, 0, 0}, {100, 0, 0}});
    std::vector<Phrase> notes;
    const FoldOut made = fold_out(model, 170, 240, find_medium("swell", ""), {}, notes);
    EXPECT_FALSE(made.drawing.strokes.empty());
    ASSERT_FALSE(notes.empty());
    EXPECT_NE(notes.front().english().find("faces without area"), std::string::npos) << notes.front().english();
    model.objects.back().count = 2;  // without the one that has no area
    notes.clear();
    fold_out(model, 170, 240, find_medium("swell", ""), {}, notes);
    ASSERT_FALSE(notes.empty());
    EXPECT_EQ(notes.front().english(), "1 face without area, or that was there twice, is left out");
    Model none;
    add_object(none, "None");
    add_face(none, {{0, 0, 0}, {50, 0, 0}, {100, 0, 0}});
    EXPECT_THROW(fold_out(none, 170, 240, find_medium("swell", ""), {}, notes), Error);
}

}  // namespace
}  // namespace tactics::fold_out_test
