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

double side_of(Point p, Point a, Point b) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

// Of a lead line with what was on the page before it: naive, and not where it ends. Another lead line counts four times.
int crossings(const PageStroke& lead, const std::vector<PageStroke>& strokes) {
    int count = 0;
    const Point from = lead.points[0], end = lead.points[1];
    const double length = distance(from, end), most = length - lead.width / 2 - 1;
    const Point to{from.x + most / length * (end.x - from.x), from.y + most / length * (end.y - from.y)};
    for (const PageStroke& other : strokes) {
        if (&other == &lead) break;
        for (std::size_t i = 0; i + 1 < other.points.size(); ++i) {
            const Point a = other.points[i], b = other.points[i + 1];
            const int times = other.role == Role::lead ? 4 : 1;
            if (side_of(a, from, to) * side_of(b, from, to) < 0 && side_of(from, a, b) * side_of(to, a, b) < 0) count += times;
        }
    }
    return count;
}

double counted(const Page& page) {
    double cost = 6 * static_cast<double>(page.left_out.size());
    for (const PageName& name : page.names) {
        const Point near = nearest_of(name.place, name.thing);
        cost += !name.key.empty() ? 3 : distance(near, name.thing) > kBesideThing + 0.01 ? 1.5 : 0;
    }
    for (const PageStroke& stroke : page.strokes)
        if (stroke.role == Role::lead) cost += 0.1 * crossings(stroke, page.strokes);
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
