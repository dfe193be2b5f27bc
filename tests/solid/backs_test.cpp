// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/backs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tactics/solid/part.h"
#include "tests/solid/models.h"

namespace tactics::tests::backs_test {
namespace {

std::vector<ModelPart> parts_in(const Model& model) {
    std::vector<Phrase> notes;
    return parts_of(model, {}, {}, notes);
}

// A square cut into two triangles along one diagonal or the other, which look that way or the other.
void add_square(Model& model, const std::vector<Point3>& corners, bool other_diagonal, bool turned) {
    const std::size_t first = other_diagonal ? 1 : 0;
    for (const std::size_t half : {std::size_t{1}, std::size_t{2}}) {
        std::vector<Point3> face = {corners[first], corners[(first + half) % 4], corners[(first + half + 1) % 4]};
        if (turned) std::reverse(face.begin(), face.end());
        add_face(model, face);
    }
}

std::vector<std::vector<Point3>> sides_of_a_box(double x, double y, double z) {
    const auto at = [&](int i) { return Point3{i & 1 ? x : 0, i & 2 ? y : 0, i & 4 ? z : 0}; };
    const int corners[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    std::vector<std::vector<Point3>> sides;
    for (const auto& side : corners) sides.push_back({at(side[0]), at(side[1]), at(side[2]), at(side[3])});
    return sides;
}

TEST(Backs, ABoxThatIsThereFromBothSidesIsABoxHoweverEachIsCut) {
    for (int cut = 0; cut < 4; ++cut) {
        Model model;
        add_object(model, "Box");
        for (const auto& side : sides_of_a_box(300, 400, 500)) {
            add_square(model, side, (cut & 1) != 0, false);
            add_square(model, side, (cut & 2) != 0, true);
        }
        const auto parts = parts_in(model);
        ASSERT_EQ(parts.size(), 1u) << cut;
        EXPECT_TRUE(parts[0].solid.closed) << cut;
        ASSERT_EQ(parts[0].solid.patches.size(), 6u) << cut;
        EXPECT_EQ(parts[0].solid.seams.size(), 12u) << cut;
        const Point3 middle{150, 200, 250};
        for (const Patch& patch : parts[0].solid.patches)
            EXPECT_GT(dot(patch.normal, patch.rings.front().front() - middle), 0) << cut;
    }
}

// A block against a wall has a back that is a part of the wall's front, and covers less: both stay.
TEST(Backs, WhatCoversLessIsNoBack) {
    WeldedSurface surface;
    surface.corners = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {5, 5, 0}, {8, 5, 0}, {8, 8, 0}, {5, 8, 0}};
    surface.faces = {{0, 1, 2, 3}, {7, 6, 5, 4}};
    surface.tolerance = 1e-4;
    EXPECT_EQ(drop_backs(surface), 0u);
    EXPECT_EQ(surface.faces.size(), 2u);
}

// A step on the one below it covers as much of that as that of it, and both are to be seen beside the other.
TEST(Backs, WhatIsShiftedIsNoBack) {
    WeldedSurface surface;
    surface.corners = {{0, 0, 0},   {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {5, 0, 0},   {15, 0, 0},
                       {15, 10, 0}, {5, 10, 0}, {0, 0, 9},   {10, 0, 9}, {10, 10, 9}, {0, 10, 9}};
    surface.faces = {{0, 1, 2, 3}, {7, 6, 5, 4}, {8, 9, 10, 11}, {11, 10, 9, 8}};  // the last two: a sheet from both sides
    surface.tolerance = 1e-4;
    EXPECT_EQ(drop_backs(surface), 1u);
    EXPECT_EQ(surface.faces.size(), 3u);
}

TEST(Backs, OfASheetTheSideStaysThatLooksUp) {
    for (const bool first_up : {true, false}) {
        WeldedSurface surface;
        surface.corners = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
        surface.faces = {{0, 1, 2}, {0, 2, 3}, {3, 1, 0}, {3, 2, 1}};
        if (!first_up) std::rotate(surface.faces.begin(), surface.faces.begin() + 2, surface.faces.end());
        surface.tolerance = 1e-4;
        EXPECT_EQ(drop_backs(surface), 2u);
        for (const CornerRing& face : surface.faces) EXPECT_GT(doubled_area(surface.corners, face).z, 0);
    }
}

// Two boxes that meet in an edge: four faces there, of which one has a corner that the others do not have.
TEST(Backs, BoxesThatMeetInAnEdgeStayWholeWhereAFaceIsCut) {
    for (const bool cut : {false, true}) {
        Model model;
        add_object(model, "Boxes");
        bool is_cut = !cut;
        for (const auto& side : sides_of_a_box(100, 100, 100)) add_face(model, side);
        for (auto side : sides_of_a_box(-100, -100, 100)) {  // turned twice: looks outwards again
            // The edge in common is upright, at 0, 0.
            for (std::size_t i = 0; !is_cut && i < side.size(); ++i) {
                const Point3 a = side[i], b = side[(i + 1) % side.size()];
                if (a.x != 0 || a.y != 0 || b.x != 0 || b.y != 0) continue;
                side.insert(side.begin() + static_cast<std::ptrdiff_t>(i) + 1, Point3{0, 0, 37});
                is_cut = true;
            }
            add_face(model, side);
        }
        const auto parts = parts_in(model);
        ASSERT_EQ(parts.size(), 1u);
        EXPECT_TRUE(parts[0].solid.closed) << cut;
        EXPECT_EQ(parts[0].solid.patches.size(), 12u) << cut;
        for (const Seam& seam : parts[0].solid.seams) EXPECT_GT(seam.bend, 1) << "a seam from one box to the other";
    }
}

// Courses of bricks, every other shifted by half: the wall's front is one plane, without a part of a joint.
TEST(Backs, OfBricksInCoursesNoJointIsLeftInPart) {
    Model model;
    add_object(model, "Wall");
    for (int course = 0; course < 3; ++course)
        for (int brick = 0; brick < 4; ++brick)
            for (auto side : sides_of_a_box(200, 100, 100)) {
                for (Point3& at : side) at = at + Point3{200.0 * brick + (course == 1 ? 100 : 0), 0, 100.0 * course};
                add_face(model, side);
            }
    const auto parts = parts_in(model);
    ASSERT_EQ(parts.size(), 1u);
    int fronts = 0;
    for (const Patch& patch : parts[0].solid.patches) {
        if (patch.normal.y > -0.9) continue;
        ++fronts;
        ASSERT_EQ(patch.rings.size(), 1u);
        EXPECT_EQ(patch.rings[0].size(), 12u);
        EXPECT_NEAR(patch.area, 240000, 1);
    }
    EXPECT_EQ(fronts, 1);
}

// A face that leans by a third of a degree is no part of its neighbour, however it is cut.
TEST(Backs, APartOfAFaceThatLeansALittleIsNoPartOfItsNeighbour) {
    const auto areas = [](bool cut) {
        Model model;
        add_object(model, "Roof");
        add_face(model, {{0, 0, 0}, {1000, 0, 0}, {1000, 1000, 0}, {0, 1000, 0}});
        const double rise = 1000 * std::tan(0.3 * 3.14159265358979 / 180);
        if (cut) {
            add_face(model, {{0, 1000, 0}, {1000, 1000, 0}, {500, 1100, rise / 10}});
            add_face(model, {{0, 1000, 0}, {500, 1100, rise / 10}, {0, 2000, rise}});
            add_face(model, {{1000, 1000, 0}, {1000, 2000, rise}, {500, 1100, rise / 10}});
            add_face(model, {{0, 2000, rise}, {500, 1100, rise / 10}, {1000, 2000, rise}});
        } else {
            add_face(model, {{0, 1000, 0}, {1000, 1000, 0}, {1000, 2000, rise}, {0, 2000, rise}});
        }
        std::vector<double> found;
        const auto parts = parts_in(model);
        for (const Patch& patch : parts[0].solid.patches) found.push_back(patch.area);
        std::sort(found.begin(), found.end());
        return found;
    };
    const auto whole = areas(false), cut = areas(true);
    ASSERT_EQ(whole.size(), 2u);
    ASSERT_EQ(cut.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(whole[i], cut[i], 1);
}

}  // namespace
}  // namespace tactics::tests::backs_test
