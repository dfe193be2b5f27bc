// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/revolution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tactics/geometry/course.h"
#include "tactics/solid/fold_out.h"
#include "tests/solid/folded.h"
#include "tests/solid/models.h"

namespace tactics::revolution_test {
namespace {

using namespace tests;

std::vector<ModelPart> parts_in(const Model& model) {
    std::vector<Phrase> notes;
    return parts_of(model, {}, {}, notes);
}

// Turned by 0.7 and 0.4, and moved.
Point3 leant(const Point3& at) {
    const double x = at.x * std::cos(0.7) - at.z * std::sin(0.7), z = at.x * std::sin(0.7) + at.z * std::cos(0.7);
    return {x * std::cos(0.4) - at.y * std::sin(0.4) + 500, x * std::sin(0.4) + at.y * std::cos(0.4) - 300, z + 40};
}

void tremble(Model& model, double size) {
    std::mt19937 chance(1);
    const auto by = [&] { return 1e-6 * size * (static_cast<double>(chance()) / 4294967295.0 - 0.5); };
    for (Point3& at : model.vertices) at = at + Point3{by(), by(), by()};
}

double off_profile(const Revolution& round, const Point3& at) {
    const Point3 away = at - round.foot;
    const double height = dot(away, round.axis);
    const Point place{length_of(away - height * round.axis), height};
    double least = 1e300;
    for (const ProfileLine& line : round.profile)
        for (std::size_t i = 0; i + (line.closed ? 0 : 1) < line.points.size(); ++i)
            least = std::min(least, distance_to_segment(place, line.points[i], line.points[(i + 1) % line.points.size()]));
    return least;
}

// Whatever the mesh: few or many facets, triangles, trembling corners, leaning, in another unit.
TEST(Revolution, ACupIsAVesselHoweverItIsWritten) {
    for (const int sides : {10, 16, 32, 90})
        for (const bool triangles : {false, true})
            for (const bool leaning : {false, true})
                for (const double unit : {0.001, 1.0, 50.0}) {
                    Model model;
                    add_turned(model, "Cup", {10, 20, 30}, cup_profile(), sides, triangles);
                    for (Point3& at : model.vertices) at = unit * (leaning ? leant(at) : at);
                    tremble(model, 90 * unit);
                    if (triangles) std::reverse(model.faces.begin(), model.faces.end());
                    const std::vector<ModelPart> parts = parts_in(model);
                    ASSERT_EQ(parts.size(), 1u);
                    ASSERT_TRUE(parts[0].round) << sides << triangles << leaning << unit;
                    const Revolution& round = *parts[0].round;
                    EXPECT_TRUE(round.is_vessel());
                    EXPECT_FALSE(round.has_handle());
                    EXPECT_NEAR(round.widest, 40 * unit, 0.1 * unit);
                    EXPECT_NEAR(round.height, 90 * unit, 0.1 * unit);
                    EXPECT_NEAR(round.high.radius, 36 * unit, 0.3 * unit);
                    EXPECT_NEAR(round.low.radius, 30 * unit, 0.3 * unit);
                    for (const Point3& at : model.vertices) EXPECT_LT(off_profile(round, at), 0.3 * unit);
                }
}

TEST(Revolution, PrimitivesAreRemembered) {
    const auto shape_of = [](const std::vector<Point>& profile) {
        Model model;
        add_turned(model, "Thing", {}, profile, 24, true);
        const std::vector<ModelPart> parts = parts_in(model);
        return parts.size() == 1 && parts[0].round ? parts[0].round->primitive : Primitive::box;
    };
    EXPECT_EQ(shape_of({{0, 0}, {50, 0}, {50, 120}, {0, 120}}), Primitive::cylinder);
    EXPECT_EQ(shape_of({{0, 0}, {50, 0}, {0, 120}}), Primitive::cone);
    EXPECT_EQ(shape_of({{0, 0}, {50, 0}, {50, 60}, {20, 120}, {20, 160}, {0, 160}}), Primitive::none);
    std::vector<Point> half;
    for (int i = 0; i <= 12; ++i)
        half.push_back({100 * std::sin(std::numbers::pi * i / 12), -100 * std::cos(std::numbers::pi * i / 12)});
    half.front().x = half.back().x = 0;
    EXPECT_EQ(shape_of(half), Primitive::sphere);
}

TEST(Revolution, WhatAHandTellsFromARoundThingIsNone) {
    Model model;
    add_box(model, "Box", -1, {0, 0, 50}, {100, 100, 100});
    for (const int sides : {5, 6, 8, 9})
        add_turned(model, "Prism", {sides * 300.0, 0, 0}, {{0, 0}, {80, 0}, {80, 120}, {0, 120}}, sides);
    // An oval tub.
    const std::size_t first = model.vertices.size();
    add_turned(model, "Tub", {}, {{0, 0}, {80, 0}, {80, 120}}, 32);
    for (std::size_t i = first; i < model.vertices.size(); ++i) model.vertices[i].x = 1.4 * model.vertices[i].x - 500;
    for (const ModelPart& part : parts_in(model)) EXPECT_FALSE(part.round) << model.objects[part.object].name;
}

TEST(Revolution, TenSidesAreRound) {
    for (const bool open : {false, true}) {
        std::vector<Point> profile = {{0, 0}, {80, 0}, {80, 120}, {0, 120}};
        if (open) profile.pop_back();
        Model model;
        add_turned(model, "Ten", {}, profile, 10);
        add_turned(model, "Nine", {300, 0, 0}, profile, 9);
        const std::vector<ModelPart> parts = parts_in(model);
        ASSERT_EQ(parts.size(), 2u);
        EXPECT_TRUE(parts[0].round);
        EXPECT_FALSE(parts[1].round);
    }
}

// However fine, whatever the thickness of its wall.
TEST(Revolution, ARoundBottomIsNoCircle) {
    for (const int steps : {4, 12, 40, 90}) {
        std::vector<Point> half, flat, dented = {{0, 12}, {40, 0}, {60, 20}, {80, 90}};
        for (int i = 0; i <= steps; ++i) {
            const double turn = std::numbers::pi / 2 * i / steps;
            half.push_back({100 * std::sin(turn), 100 - 100 * std::cos(turn)});
            flat.push_back({50 + 50 * std::sin(turn), 100 - 100 * std::cos(turn)});
        }
        flat.insert(flat.begin(), {0, 0});
        std::vector<Point> walled = half;
        for (std::size_t i = half.size(); i-- > 0;) walled.push_back({0.94 * half[i].x, 100 - 0.94 * (100 - half[i].y)});
        for (const auto& [profile, radius] : {std::pair(half, 0.0), {walled, 0.0}, {flat, 50.0}, {dented, 40.0}}) {
            Model model;
            add_turned(model, "Bowl", {}, profile, 32);
            const std::vector<ModelPart> parts = parts_in(model);
            ASSERT_TRUE(parts.size() == 1 && parts[0].round) << steps;
            ASSERT_TRUE(parts[0].round->is_vessel()) << steps;
            const Revolution& round = *parts[0].round;
            // A fillet begins nearly flat.
            EXPECT_NEAR((round.low.open ? round.high : round.low).radius, radius, radius > 0 ? 2.5 : 0.1) << steps;
        }
    }
    Model model;
    add_turned(model, "Bowl", {}, {{0, 0}, {38, 8}, {71, 29}, {92, 62}, {100, 100}}, 32);
    std::vector<Phrase> notes;
    const FoldOut made = fold_out(model, 170, 240, find_medium("swell", ""), {}, notes);
    for (const Stroke& stroke : made.drawing.strokes) EXPECT_NE(stroke.role, Role::dash);
    EXPECT_EQ(made.drawing.regions.size(), 2u);
    ASSERT_EQ(made.drawing.names.size(), 2u);
    EXPECT_EQ(made.drawing.names.back().text, "opening");
    EXPECT_EQ(made.objects.front().left_out, 0);
}

// In one piece with the cup, or beside it in the same object.
TEST(Revolution, AHandleBelongsToItsCup) {
    Model model;
    add_turned(model, "Cup", {}, cup_profile(), 32);
    add_handle(model, {}, 37, 30);
    for (Point3& at : model.vertices) at = leant(at);
    const std::vector<ModelPart> parts = parts_in(model);
    ASSERT_EQ(parts.size(), 1u);
    ASSERT_TRUE(parts[0].round && parts[0].round->has_handle());
    const Revolution& round = *parts[0].round;
    EXPECT_GT(dot(round.handle, leant({1, 0, 0}) - leant({})), 0.99);
    EXPECT_NEAR(round.widest, 40, 0.5);
    double reach = 0;
    for (const ProfileLine& line : round.handled)
        for (const Point& at : line.points) reach = std::max(reach, at.x);
    EXPECT_NEAR(reach, 71, 1);
}

// M. Kurze, CHI 1997, fig. 8: readers took the opening of a pot for its bottom.
TEST(Revolution, OpeningAndBottomOfEqualSizeAreToldApart) {
    Model model;
    add_turned(model, "Pot", {}, {{0, 0}, {80, 0}, {80, 120}}, 36);
    for (const FoldPlane plane : {FoldPlane::above, FoldPlane::front}) {
        std::vector<Phrase> notes;
        const FoldOut made = fold_out(model, 170, 240, find_medium("swell", ""), {.plane = plane}, notes);
        double dashed = 0, whole = 0;
        for (const Stroke& stroke : made.drawing.strokes) (stroke.role == Role::dash ? dashed : whole) += length_of(stroke);
        EXPECT_NEAR(dashed, made.scale * 2 * std::numbers::pi * 80, 2);
        EXPECT_NEAR(whole, made.scale * (2 * std::numbers::pi * 80 + 2 * 120 + 160), 3);
        std::vector<std::string> regions, names;
        for (const Region& region : made.drawing.regions) {
            regions.push_back(region.name.english());
            EXPECT_TRUE(holds(region, region.at));
        }
        std::sort(regions.begin(), regions.end());
        EXPECT_EQ(regions, (std::vector<std::string>{"Pot", "Pot: bottom", "Pot: section"}));
        for (const Name& name : made.drawing.names) names.push_back(name.text);
        EXPECT_EQ(names, (std::vector<std::string>{"Pot", "opening", "bottom"}));
        EXPECT_EQ(made.objects.front().shape, "vessel");
    }
}

// A circle that touched the section would run along it for a while, and its first dash with it.
TEST(Revolution, EndsLieAGapFromTheSection) {
    for (const double thick : {0.0, 4.0, 20.0})
        for (const FoldPlane plane : {FoldPlane::above, FoldPlane::front})
            for (const char* name : {"swell", "embosser"}) {
                std::vector<Point> profile = {{0, 0}, {80, 0}, {80, 120}};
                if (thick > 0) profile.insert(profile.end(), {{80 - thick, 120}, {80 - thick, thick}, {0, thick}});
                Model model;
                add_turned(model, "Cup", {}, profile, 32);
                const Medium medium = find_medium(name, "");
                std::vector<Phrase> notes;
                const FoldOut made = fold_out(model, 170, 240, medium, {.plane = plane}, notes);
                const double least = least_apart(medium, medium.line, medium.line);
                double nearest = 1e300;
                for (const Stroke& dashed : made.drawing.strokes)
                    for (const Stroke& whole : made.drawing.strokes) {
                        if (dashed.role != Role::dash || whole.role == Role::dash) continue;
                        for (const Point& at : dashed.points)
                            for (std::size_t i = 0; i + (whole.closed ? 0 : 1) < whole.points.size(); ++i)
                                nearest = std::min(nearest, distance_to_segment(at, whole.points[i],
                                                                                whole.points[(i + 1) % whole.points.size()]));
                    }
                EXPECT_GE(nearest, least) << name << thick;
                EXPECT_LT(nearest, 1.1 * least) << name << thick;
            }
}

TEST(Revolution, AHandComesToABottomWhereverItsOpeningIsListed) {
    Model model;
    add_turned(model, "Pot", {}, {{0, 0}, {80, 0}, {80, 120}}, 36);
    Folded made = folded(model);
    std::vector<Panel>& list = made.panels.panels;
    const auto bottom = std::find_if(list.begin(), list.end(), [](const Panel& one) { return one.kind == PanelKind::bottom; });
    ASSERT_NE(bottom, list.end());
    ASSERT_EQ(list[bottom->opening].kind, PanelKind::opening);
    EXPECT_TRUE(bottom->reached);
    const auto place = static_cast<std::uint32_t>(bottom - list.begin());
    std::swap(*bottom, list[bottom->opening]);
    Panel& moved = *std::find_if(list.begin(), list.end(), [](const Panel& one) { return one.kind == PanelKind::bottom; });
    moved.opening = place;
    find_reached(made.panels, made.parts, {.floor = true});
    EXPECT_TRUE(moved.reached);
}

// A cylinder of a file that has one, and the same as a mesh.
TEST(Revolution, AMeshIsDrawnAsThePrimitive) {
    for (const bool open : {false, true}) {
        Model primitive, mesh;
        add_cylinder(primitive, "Pot", -1, {0, 0, 60}, 80, 120, open);
        std::vector<Point> profile = {{0, 0}, {80, 0}, {80, 120}, {0, 120}};
        if (open) profile.pop_back();
        add_turned(mesh, "Pot", {}, profile, 24);
        const auto length = [](const Model& model) {
            const Folded made = folded(model);
            double sum = 0;
            for (const PlacedPanel& placed : made.layout.panels) sum += area_of(placed.shape);
            return sum;
        };
        EXPECT_NEAR(length(primitive), length(mesh), 1e-3 * length(mesh));
    }
}

TEST(Revolution, AShadeHasNoBottomAndAWheelIsCutTwice) {
    Model shade;
    add_turned(shade, "Shade", {0, 0, 200}, {{110, 0}, {60, 150}}, 32);
    const std::vector<ModelPart> parts = parts_in(shade);
    ASSERT_TRUE(parts.front().round);
    EXPECT_TRUE(parts.front().round->low.open && parts.front().round->high.open);
    Model wheel;
    add_turned(wheel, "Wheel", {}, {{200, 0}, {300, 0}, {310, 50}, {300, 100}, {200, 100}, {195, 50}, {200, 0}}, 32);
    const Folded made = folded(wheel);
    const auto section = std::find_if(made.layout.panels.begin(), made.layout.panels.end(), [&](const PlacedPanel& one) {
        return made.panels.panels[one.panel].kind == PanelKind::section;
    });
    ASSERT_NE(section, made.layout.panels.end());
    const Panel& panel = made.panels.panels[section->panel];
    EXPECT_EQ(panel.lines.size(), 2u);
    for (const PanelLine& line : panel.lines) EXPECT_TRUE(line.closed);
}

}  // namespace
}  // namespace tactics::revolution_test
