// SPDX-License-Identifier: Apache-2.0
// Where the drawing begins below a title.
#include "filters/first_ink.h"

#include <gtest/gtest.h>

#include "tests/filters/pictures.h"

namespace tactics::first_ink_test {
namespace {

constexpr int kWide = 200, kHigh = 300;

// A line that begins a tenth down, and the edges that have a line of a frame.
Image framed(int pale, bool top, bool bottom, bool sides) {
    return pictures::drawn(kWide, kHigh, [=](int x, int y) {
        if ((top && y == 1) || (bottom && y == kHigh - 2) || (sides && (x == 1 || x == kWide - 2))) return pale;
        return y == kHigh / 10 && x > 40 && x < 150 ? 0 : 255;
    });
}

TEST(FirstInk, IsBelowAFrameAroundTheWhole) {
    for (const int pale : {0, 191}) EXPECT_DOUBLE_EQ(first_ink(framed(pale, true, true, true)), 10) << pale;
    EXPECT_DOUBLE_EQ(first_ink(framed(0, false, false, false)), 10);
    EXPECT_DOUBLE_EQ(first_ink(make_image(kWide, kHigh, 1, 0.2, 255)), 100);
}

TEST(FirstInk, IsTheTopOfABoxThere) {
    for (const int pale : {0, 191}) {
        EXPECT_DOUBLE_EQ(first_ink(framed(pale, true, false, true)), 0) << pale;
        EXPECT_DOUBLE_EQ(first_ink(framed(pale, true, true, false)), 0) << pale;
    }
}

}  // namespace
}  // namespace tactics::first_ink_test
