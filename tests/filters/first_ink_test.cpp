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
    for (const int pale : {0, 191}) EXPECT_DOUBLE_EQ(first_ink(framed(pale, true, true, true)).top, 10) << pale;
    EXPECT_DOUBLE_EQ(first_ink(framed(0, false, false, false)).top, 10);
    EXPECT_DOUBLE_EQ(first_ink(make_image(kWide, kHigh, 1, 0.2, 255)).top, 100);
}

TEST(FirstInk, IsTheTopOfABoxThere) {
    for (const int pale : {0, 191}) {
        EXPECT_DOUBLE_EQ(first_ink(framed(pale, true, false, true)).top, 0) << pale;
        EXPECT_DOUBLE_EQ(first_ink(framed(pale, true, true, false)).top, 0) << pale;
    }
}

TEST(FirstInk, TellsHowWideItBegins) {
    Image image = make_image(200, 100, 1, 0.2, 255);
    for (int y = 20; y < 60; ++y)
        for (int x = y < 26 ? 90 : 10; x < 94; ++x) image.row(y)[x] = 0;
    const FirstInk first = first_ink(image);
    EXPECT_DOUBLE_EQ(first.top, 20);
    EXPECT_DOUBLE_EQ(first.left, 45);
    EXPECT_DOUBLE_EQ(first.right, 47);
}

}  // namespace
}  // namespace tactics::first_ink_test
