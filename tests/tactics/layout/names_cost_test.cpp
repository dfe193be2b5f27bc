// SPDX-License-Identifier: Apache-2.0
// What the names of a page cost a hand, counted on the finished page, and when laying them out is given up.
#include <gtest/gtest.h>

#include <limits>

#include "tactics/layout/lay_out.h"
#include "tactics/layout/room.h"

namespace tactics::names_cost_test {
namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();

Sheet sheet() {
    Sheet sheet;
    sheet.paper = find_paper("a4", "test");
    sheet.medium = &find_medium("swell", "test");
    return sheet;
}

// A lattice whose places are named: wide meshes have room for words, narrow ones for leads and letters, the narrowest for
// nothing.
Drawing lattice(double mesh, int names) {
    Drawing drawing;
    drawing.width = 180;
    drawing.height = 120;
    for (double x = 0; x <= 180; x += mesh) drawing.strokes.push_back({{{x, 0}, {x, 120}}});
    for (double y = 0; y <= 120; y += mesh) drawing.strokes.push_back({{{0, y}, {180, y}}});
    for (int i = 0; i < names; ++i)
        drawing.names.push_back({{7.0 + (37 * i) % 170, 5.0 + (53 * i) % 110}, "place " + std::to_string(i), "test", 0, true});
    return drawing;
}

double counted(const Page& page) {
    double cost = 6 * static_cast<double>(page.left_out.size());
    for (const PageName& name : page.names) {
        const Point near = nearest_of(name.place, name.thing);
        cost += !name.key.empty() ? 3 : distance(near, name.thing) > kBesideThing + 0.01 ? 1.5 : 0;
    }
    return cost;
}

TEST(NamesCost, IsThatOfThePage) {
    for (const double mesh : {60.0, 30.0, 20.0, 12.0, 9.0, 5.0}) {
        SCOPED_TRACE(mesh);
        const Drawing drawing = lattice(mesh, 12);
        const Page page = lay_out(drawing, sheet());
        const auto names = cost_of_names(drawing, sheet(), arrange(sheet(), 1.5), kAny);
        ASSERT_TRUE(names);
        EXPECT_EQ(names->cost, counted(page));
        EXPECT_EQ(names->left_out, page.left_out.size());
    }
}

TEST(NamesCost, IsGivenUpWhereItIsTooMuchAndNowhereElse) {
    for (const double mesh : {30.0, 12.0, 5.0}) {
        SCOPED_TRACE(mesh);
        const Drawing drawing = lattice(mesh, 12);
        const Arrangement arrangement = arrange(sheet(), 1.5);
        const auto names = cost_of_names(drawing, sheet(), arrangement, kAny);
        ASSERT_TRUE(names);
        for (const double most : {0.5, 1.5, 3.0, 10.0, 30.0, names->cost, names->cost + 0.5}) {
            const auto bounded = cost_of_names(drawing, sheet(), arrangement, most);
            EXPECT_EQ(bounded.has_value(), names->cost < most) << most;
            EXPECT_EQ(bounded.value_or(*names).cost, names->cost);
        }
    }
}

}  // namespace
}  // namespace tactics::names_cost_test
