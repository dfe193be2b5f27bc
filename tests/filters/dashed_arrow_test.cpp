// SPDX-License-Identifier: Apache-2.0
// The line of an arrow may have dashes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "filters/known_parts.h"
#include "tests/filters/pictures.h"

namespace tactics::dashed_arrow_test {
namespace {

// As graphviz draws a link: the last gap is before the head, which touches the box that it points at.
Image link_of(int dash, int period) {
    return pictures::drawn(200, 200, [&](int x, int y) {
        const bool box = x >= 60 && x < 140 && y >= 149 && y < 151;
        const bool head = y >= 132 && y < 150 && std::abs(x + 0.5 - 100) <= 6 * (150 - y) / 18.0;
        const bool line = std::abs(x + 0.5 - 100) < 1 && y >= 20 && y < 126 && (y - 20) % period < dash;
        return box || head || line ? 0 : 255;
    });
}

TEST(DashedArrow, HasAHeadAndGoesOnToItsTip) {
    for (const auto& [dash, period] : {std::pair{8, 20}, std::pair{4, 16}}) {
        Image picture = link_of(dash, period);
        const KnownParts parts = take_known_parts(picture);
        const auto is_head = [](const Stroke& one) { return one.role == Role::arrow; };
        const auto head = std::find_if(parts.strokes.begin(), parts.strokes.end(), is_head);
        const auto row = std::find_if_not(parts.strokes.begin(), parts.strokes.end(), is_head);
        ASSERT_NE(head, parts.strokes.end()) << dash;
        ASSERT_NE(row, parts.strokes.end()) << dash;
        const Point tip = head->points[1];
        EXPECT_NEAR(tip.y, 149 * pictures::kPixel, 0.5);
        EXPECT_LT(std::min(distance(row->points.front(), tip), distance(row->points.back(), tip)), 0.1);
        EXPECT_GE(picture.row(140)[100], 200) << "no stub of the line is left";
    }
}

// Cairo leaves a pale pixel where the line of an open head ends and its head begins.
TEST(DashedArrow, MayHaveAPaleSeamBeforeItsHead) {
    Image picture = pictures::drawn(200, 200, [](int x, int y) {
        const double off = std::abs(x + 0.5 - 100), behind = 150 - y;
        const bool box = x >= 60 && x < 140 && y >= 149 && y < 151;
        const bool head = behind > 0 && behind <= 32 && off <= behind / 2 && off >= (behind - 17);
        const bool line = off < 1.5 && y >= 20 && y < 140;
        if (line && y == 126) return 180;
        return box || head || line ? 0 : 255;
    });
    const KnownParts parts = take_known_parts(picture);
    EXPECT_TRUE(
        std::any_of(parts.strokes.begin(), parts.strokes.end(), [](const Stroke& one) { return one.role == Role::arrow; }));
}

}  // namespace
}  // namespace tactics::dashed_arrow_test
