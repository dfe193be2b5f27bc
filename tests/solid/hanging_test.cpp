// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/hanging.h"

#include <gtest/gtest.h>

#include "tactics/solid/fold_out.h"
#include "tactics/solid/lay_flat.h"
#include "tactics/solid/panels.h"
#include "tactics/solid/reach.h"
#include "tactics/solid/thing.h"
#include "tests/solid/models.h"

namespace tactics::hanging_test {
namespace {

using namespace tests;

struct Hung {
    std::vector<ModelPart> parts;
    Panels panels;
    FlatLayout layout;

    // The only panel that is laid of an object.
    const PlacedPanel* of(const Model& model, const std::string& name) const {
        const PlacedPanel* found = nullptr;
        for (const PlacedPanel& one : layout.panels)
            if (model.objects[parts[panels.panels[one.panel].part].object].name == name) {
                EXPECT_EQ(found, nullptr) << name;
                found = &one;
            }
        return found;
    }
};

Hung hung(const Model& model) {
    Hung made;
    std::vector<Phrase> notes;
    made.parts = parts_of(model, {}, {}, notes);
    const auto thing = things_of(model, made.parts);
    made.panels = panels_of(made.parts, thing, kFromAbove);
    find_reached(made.panels, made.parts, {});
    made.layout = lay_flat(made.parts, made.panels, thing, kFromAbove, {});
    return made;
}

TEST(Hanging, IsToldAsWhatItIs) {
    Model bench;
    const int all = add_group(bench, "Bench");
    add_box(bench, "Top", all, {0, 0, 420}, {1600, 400, 40});
    add_box(bench, "Left", all, {-600, 0, 200}, {150, 300, 400});
    std::vector<Phrase> notes;
    const FoldOut made = fold_out(bench, 180, 250, find_medium("swell", "test"), {.plane = FoldPlane::above}, notes);
    for (const FoldedObject& one : made.objects) EXPECT_EQ(one.hanging, one.name == "Left" ? 1 : 0) << one.name;
    for (const Region& region : made.drawing.regions)
        EXPECT_EQ(region.description.english().find("from its side") != std::string::npos, region.name.english() == "Left")
            << region.description.english();
}

TEST(Hanging, ThickLegsLieBesideTheTopInTheirTrueSize) {
    Model bench;
    const int all = add_group(bench, "Bench");
    add_box(bench, "Top", all, {0, 0, 420}, {1600, 400, 40});
    add_box(bench, "Left", all, {-600, 0, 200}, {150, 300, 400});
    add_box(bench, "Right", all, {600, 0, 200}, {150, 300, 400});
    const Hung made = hung(bench);
    const PlacedPanel* top = made.of(bench, "Top");
    ASSERT_NE(top, nullptr);
    for (const char* name : {"Left", "Right"}) {
        const PlacedPanel* leg = made.of(bench, name);
        ASSERT_NE(leg, nullptr) << name;
        EXPECT_EQ(made.panels.panels[leg->panel].kind, PanelKind::hanging);
        EXPECT_NEAR(std::max(leg->shape.box.width(), leg->shape.box.height()), 400, 2);
        EXPECT_LT(distance(leg->shape, top->shape), 1e-6);
        EXPECT_EQ(meeting_of(leg->shape, top->shape, 1), ShapeMeeting::apart);
    }
}

TEST(Hanging, AFootHangsOnItsColumn) {
    Model cafe;
    const int all = add_group(cafe, "Table");
    add_cylinder(cafe, "Top", all, {0, 0, 725}, 400, 30);
    add_cylinder(cafe, "Column", all, {0, 0, 370}, 60, 680);
    add_cylinder(cafe, "Foot", all, {0, 0, 15}, 250, 30);
    const Hung made = hung(cafe);
    const PlacedPanel *column = made.of(cafe, "Column"), *foot = made.of(cafe, "Foot");
    ASSERT_TRUE(column != nullptr && foot != nullptr);
    // Towards the reader; outlines are right to 0.2 %.
    EXPECT_NEAR(column->shape.box.width(), 120, 3);
    EXPECT_NEAR(column->shape.box.height(), 680, 3);
    EXPECT_NEAR(foot->shape.box.width(), 500, 3);
    EXPECT_NEAR(foot->shape.box.height(), 30, 3);
    EXPECT_LT(distance(column->shape, foot->shape), 1.5);
    EXPECT_GT(foot->shape.box.top, column->shape.box.top + 600);
}

TEST(Hanging, WhatStandsOnATopOrApartHangsNowhere) {
    Model model;
    const int all = add_group(model, "Table");
    add_box(model, "Top", all, {0, 0, 720}, {1000, 800, 40});
    add_cylinder(model, "Bottle", all, {0, 0, 840}, 40, 200);
    add_box(model, "Box", -1, {0, 0, 150}, {300, 300, 300});
    for (const Panel& panel : hung(model).panels.panels) EXPECT_NE(panel.kind, PanelKind::hanging);
}

}  // namespace
}  // namespace tactics::hanging_test
