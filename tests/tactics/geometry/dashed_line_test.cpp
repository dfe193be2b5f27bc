// SPDX-License-Identifier: Apache-2.0
// Dashes are felt, and told, as one line.
#include "tactics/geometry/dashed_line.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tactics/description/description.h"

namespace tactics::dashed_line_test {
namespace {

Page page_with_dashes() {
    Page page;
    page.width = 210;
    page.height = 297;
    for (int i = 0; i < 10; ++i) page.strokes.push_back({{{20 + 12.0 * i, 50}, {27 + 12.0 * i, 50}}, false, 1, Role::dash});
    for (int i = 0; i < 5; ++i) page.strokes.push_back({{{20, 80 + 12.0 * i}, {20, 87 + 12.0 * i}}, false, 1, Role::dash});
    page.strokes.push_back({{{20, 200}, {120, 250}}, false, 1});
    page.strokes.push_back({{{120, 255}, {120, 290}}, false, 1});
    return page;
}

TEST(DashedLine, EndsWhereTheNextDashIsFarOrNone) {
    const Page page = page_with_dashes();
    EXPECT_EQ(last_of_line(page, 0), 9u);
    EXPECT_EQ(last_of_line(page, 10), 14u);
    EXPECT_EQ(last_of_line(page, 15), 15u);
    EXPECT_EQ(last_of_line(page, 16), 16u);
    EXPECT_EQ(whole_line(page, 0, 9).size(), 20u);
}

// Two dashed lines beside each other, the one beginning where the other ends: a hand would not go over from dash to dash.
TEST(DashedLine, DoesNotGoOverToOneBesideIt) {
    Page page;
    for (const double y : {50.0, 58.0})
        for (int i = 0; i < 5; ++i) {
            const double x = y == 50 ? 20 + 12.0 * i : 68 - 12.0 * i, by = y == 50 ? 7 : -7;
            page.strokes.push_back({{{x, y}, {x + by, y}}, false, 1, Role::dash});
        }
    EXPECT_EQ(last_of_line(page, 0), 4u);
    EXPECT_EQ(last_of_line(page, 5), 9u);
}

TEST(DashedLine, GoesOnBehindADashRoundACorner) {
    Page page;
    page.strokes.push_back({{{20, 50}, {27, 50}}, false, 1, Role::dash});
    page.strokes.push_back({{{32, 50}, {35, 50}, {33, 54}}, false, 1, Role::dash});  // 117 degrees
    page.strokes.push_back({{{31, 58}, {28, 64}}, false, 1, Role::dash});
    EXPECT_EQ(last_of_line(page, 0), 2u);
    page.strokes[2].points = {{40, 52}, {47, 53}};  // on in the direction before the corner
    EXPECT_EQ(last_of_line(page, 0), 1u);
}

TEST(DashedLine, IsToldAsOne) {
    const Description description = describe(page_with_dashes());
    ASSERT_EQ(description.things.size(), 4u);
    EXPECT_EQ(std::count_if(description.things.begin(), description.things.end(),
                            [](const Thing& thing) { return thing.what.english().starts_with("A dashed straight "); }),
              2);
    EXPECT_EQ(description.amounts[0].english().substr(0, 14), "On it: 4 lines");
}

}  // namespace
}  // namespace tactics::dashed_line_test
