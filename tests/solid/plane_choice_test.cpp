// SPDX-License-Identifier: Apache-2.0
#include "tactics/solid/plane_choice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tactics/solid/fold_out.h"
#include "tests/solid/models.h"

namespace tactics::plane_choice_test {
namespace {

using namespace tests;

// A board that leans back by 0.6 radians and is turned by 0.5.
Model leaning_board() {
    Model model;
    add_box(model, "Board", -1, {0, 0, 0}, {800, 500, 200});
    for (Point3& at : model.vertices) {
        const double y = at.y * std::cos(0.6) - at.z * std::sin(0.6), z = at.y * std::sin(0.6) + at.z * std::cos(0.6);
        at = {at.x * std::cos(0.5) - y * std::sin(0.5), at.x * std::sin(0.5) + y * std::cos(0.5), z};
    }
    return model;
}

FoldOut folded_out(const Model& model, FoldPlane plane) {
    std::vector<Phrase> notes;
    return fold_out(model, 170, 240, find_medium("swell", ""), {.plane = plane}, notes);
}

TEST(PlaneChoice, AFrameIsRightHandedAndUpright) {
    for (const Point3& toward : {Point3{0, 0, 1}, Point3{0, 0, -1}, unit({1, 2, 3}), unit({-3, 1, -0.2}), Point3{-1, 0, 0}}) {
        const ViewPlane view = plane_facing(toward, FoldPlane::face).view;
        EXPECT_NEAR(length_of(cross(view.down, view.right) - view.toward), 0, 1e-9);
        EXPECT_NEAR(length_of(view.toward - toward), 0, 1e-9);
        EXPECT_LE(view.down.z, 1e-9);
        EXPECT_NEAR(dot(view.right, Point3{0, 0, 1}), 0, 1e-9);
    }
    EXPECT_EQ(plane_facing({0, -1, 0}, FoldPlane::face).plane, FoldPlane::front);
}

TEST(PlaneChoice, TheLargestFaceLiesWhereItIs) {
    const FoldOut made = folded_out(leaning_board(), FoldPlane::face);
    EXPECT_EQ(made.plane, FoldPlane::face);
    EXPECT_EQ(made.objects.front().kept, 1);
    EXPECT_GE(made.objects.front().folded, 4);
    EXPECT_EQ(made.objects.front().straightened, 0);
    EXPECT_NE(made.drawing.remarks.front().english().find("square onto its largest face"), std::string::npos);
}

TEST(PlaneChoice, AViewpointChoosesTheFaceThatItLooksAt) {
    Model model;
    add_box(model, "Box", -1, {0, 0, 50}, {300, 200, 100});
    EXPECT_EQ(folded_out(model, FoldPlane::view).plane, FoldPlane::front);
    model.viewed_from = unit({0.2, -0.5, 1});
    EXPECT_EQ(folded_out(model, FoldPlane::view).plane, FoldPlane::above);
    model.viewed_from = unit({1, -0.5, 0.3});
    EXPECT_EQ(folded_out(model, FoldPlane::view).plane, FoldPlane::side);
    model.viewed_from = unit({-1, 0.1, 0.3});
    EXPECT_EQ(folded_out(model, FoldPlane::view).plane, FoldPlane::view);
}

// A pyramid has no face that looks to the front: a viewpoint there chooses one of those that lean.
TEST(PlaneChoice, AViewpointChoosesAFaceThatThereIs) {
    Model model;
    add_object(model, "Pyramid");
    const Point3 tip{0, 0, 100}, a{-100, -100, 0}, b{100, -100, 0}, c{100, 100, 0}, d{-100, 100, 0};
    add_face(model, {d, c, b, a});
    add_face(model, {a, b, tip});
    add_face(model, {b, c, tip});
    add_face(model, {c, d, tip});
    add_face(model, {d, a, tip});
    for (const Point3& from : {Point3{0, -1, 0}, unit({0.1, -1, 0.1}), unit({0.2, -1, -0.1})}) {
        model.viewed_from = from;
        const FoldOut made = folded_out(model, FoldPlane::view);
        EXPECT_EQ(made.plane, FoldPlane::view);
        EXPECT_EQ(made.objects.front().kept, 1);
        EXPECT_EQ(made.objects.front().straightened, 0);
    }
}

}  // namespace
}  // namespace tactics::plane_choice_test
