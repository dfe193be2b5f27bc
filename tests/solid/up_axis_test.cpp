// SPDX-License-Identifier: Apache-2.0
// A model whose file has another axis upwards is the same when it is told.
#include "tactics/solid/up_axis.h"

#include <gtest/gtest.h>

#include "tactics/readers/model.h"
#include "tactics/solid/fold_options.h"
#include "tactics/solid/fold_out.h"
#include "tests/solid/models.h"

namespace tactics::up_axis_test {
namespace {

Model stand() {
    Model model;
    tests::add_box(model, "Foot", -1, {0, 0, 10}, {120, 80, 20});
    tests::add_box(model, "Post", -1, {30, 20, 70}, {20, 30, 100});
    return model;
}

Model written(Model model, Point3 (*as)(const Point3&)) {
    for (Point3& at : model.vertices) at = as(at);
    return model;
}

bool same_places(const Model& one, const Model& other) { return one.vertices == other.vertices; }

TEST(UpAxis, AModelIsTheSameWhicheverAxisOfItsFileIsUpwards) {
    const Model model = stand();
    const Model y_up = written(model, [](const Point3& at) { return Point3{at.x, at.z, -at.y}; });
    const Model x_up = written(model, [](const Point3& at) { return Point3{at.z, at.x, at.y}; });
    EXPECT_TRUE(same_places(turned_up(y_up, UpAxis::y), model));
    EXPECT_TRUE(same_places(turned_up(x_up, UpAxis::x), model));
    EXPECT_TRUE(same_places(turned_up(model, UpAxis::z), model));
    EXPECT_TRUE(same_places(turned_up(y_up, UpAxis::of_file), y_up));
}

TEST(UpAxis, WhatWasTurnedWhenItWasReadIsTurnedFromItsFile) {
    Model read = stand();  // of a file with y upwards
    read.had_y_up = true;
    EXPECT_TRUE(same_places(turned_up(read, UpAxis::y), read));
    // Modelled with z upwards all the same: its z lies in -y.
    const Model wrong = written(stand(), [](const Point3& at) { return Point3{at.x, -at.z, at.y}; });
    Model told = wrong;
    told.had_y_up = true;
    EXPECT_TRUE(same_places(turned_up(told, UpAxis::z), stand()));
}

TEST(UpAxis, SolidsStaySolids) {
    for (const UpAxis up : {UpAxis::x, UpAxis::y, UpAxis::z}) {
        std::vector<Phrase> notes;
        const FoldOut made = fold_out(turned_up(stand(), up), 150, 200, find_medium("swell", "test"), {}, notes);
        EXPECT_EQ(made.objects.size(), 2u);
        EXPECT_GT(made.objects.front().folded, 0) << "a mirrored solid would have its faces inside";
    }
}

}  // namespace
}  // namespace tactics::up_axis_test
