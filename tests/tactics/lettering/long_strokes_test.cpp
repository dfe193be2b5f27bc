// SPDX-License-Identifier: Apache-2.0
// Lines that are drawn are long; strokes of letters are not.
#include "tactics/lettering/long_strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tactics::long_strokes_test {
namespace {

class LongStroke : public ::testing::Test {
protected:
    void fill(int left, int top, int right, int bottom) {
        for (int y = top; y < bottom; ++y) std::fill(ink.row(y) + left, ink.row(y) + right, std::uint8_t{1});
    }
    // Of the window's middle column and row.
    bool is_stroke(int x, int y) const { return long_strokes(ink, window, 30).strokes.row(y - window.top)[x - window.left] != 0; }
    Image ink = make_image(120, 120, 1, 0, 0);
    const PixelBox window{30, 40, 90, 80};
};

TEST_F(LongStroke, IsStraightAndMayEndInTheWindow) {
    fill(10, 50, 60, 52);
    EXPECT_TRUE(is_stroke(45, 50));
    EXPECT_FALSE(is_stroke(70, 50));
}

TEST_F(LongStroke, MayLeanAndHasStairs) {
    for (int i = 0; i < 80; ++i) ink.row(20 + i / 2)[10 + i] = ink.row(21 + i / 2)[10 + i] = 1;
    EXPECT_TRUE(is_stroke(70, 50));
    const LongStrokes found = long_strokes(ink, window, 30);
    for (int y = 0; y < window.height(); ++y)
        for (int x = 0; x < window.width(); ++x)
            EXPECT_EQ(found.beside.row(y)[x] != 0, ink.row(y + window.top)[x + window.left] != 0) << x << " " << y;
}

TEST_F(LongStroke, IsNoStrokeOfALetter) {
    fill(50, 50, 54, 75);
    fill(50, 71, 70, 75);
    EXPECT_FALSE(is_stroke(51, 60));
    EXPECT_FALSE(is_stroke(60, 72));
}

// A coast of short pieces, and a letter of it that sticks out.
TEST_F(LongStroke, MayBendOnItsWayThroughTheWindow) {
    int x = 50;
    for (int y = 20; y < 100; ++y) {
        x += y % 12 < 6 ? 1 : -1;
        fill(x, y, x + 2, y + 1);
    }
    fill(60, 58, 75, 60);
    bool all = true;
    const LongStrokes found = long_strokes(ink, window, 30);
    x = 50;
    for (int y = 20; y < 80; ++y) {
        x += y % 12 < 6 ? 1 : -1;
        all = all && (y < window.top || found.beside.row(y - window.top)[x - window.left] != 0);
    }
    EXPECT_TRUE(all);
    EXPECT_FALSE(is_stroke(70, 58));
}

}  // namespace
}  // namespace tactics::long_strokes_test
