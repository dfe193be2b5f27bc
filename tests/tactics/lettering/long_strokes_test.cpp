// SPDX-License-Identifier: Apache-2.0
// Lines that are drawn are long; strokes of letters are not.
#include "tactics/lettering/long_strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

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

// As they are defined: a run of a row or a column, or what goes on to both sides in one of 36 directions where there is none.
TEST_F(LongStroke, AreThoseOfTheDefinitionInAnyInk) {
    constexpr int kLeast = 30;
    // Without crossings of the border there are no other ways.
    const PixelBox all{0, 0, ink.width, ink.height};
    std::mt19937 random(11);
    const auto below = [&](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
    for (int turn = 0; turn < 10; ++turn) {
        std::fill(ink.pixels.begin(), ink.pixels.end(), std::uint8_t{0});
        const auto dot = [&](int x, int y) {
            if (x > 0 && y > 0 && x + 1 < ink.width && y + 1 < ink.height) ink.row(y)[x] = 1;
        };
        for (int line = 0; line < 12; ++line) {
            const double x = below(110), y = below(110), angle = below(628) / 100.0;
            for (int i = 0; i < 10 + below(60); ++i)
                for (int wide = 0; wide < 1 + line % 3; ++wide)
                    dot(static_cast<int>(x + i * std::cos(angle)) + wide, static_cast<int>(y + i * std::sin(angle)));
        }
        fill(20, 20, 20 + below(40), 20 + below(40));
        const auto at = [&](const Image& image, long x, long y) {
            return x >= 0 && y >= 0 && x < image.width && y < image.height &&
                   image.row(static_cast<int>(y))[static_cast<int>(x)] != 0;
        };
        const auto length = [&](const Image& image, int x, int y, double dx, double dy) {
            int far = 1;
            for (const int side : {1, -1})
                for (int i = 1; i < kLeast && at(image, x + side * std::lround(i * dx), y + side * std::lround(i * dy)); ++i)
                    ++far;
            return far;
        };
        Image bare = ink;
        for (int y = 0; y < ink.height; ++y)
            for (int x = 0; x < ink.width; ++x)
                if (at(ink, x, y) && (length(ink, x, y, 1, 0) >= kLeast || length(ink, x, y, 0, 1) >= kLeast)) bare.row(y)[x] = 0;
        const LongStrokes found = long_strokes(ink, all, kLeast);
        for (int y = 0; y < ink.height; ++y)
            for (int x = 0; x < ink.width; ++x) {
                bool is = at(ink, x, y) && !at(bare, x, y);
                for (int k = 0; k < 36 && !is && at(bare, x, y); ++k) {
                    const double angle = k * std::numbers::pi / 36;
                    is = length(bare, x, y, std::cos(angle), std::sin(angle)) >= kLeast;
                }
                EXPECT_EQ(found.strokes.row(y)[x] != 0, is) << turn << ": " << x << " " << y;
            }
    }
}

}  // namespace
}  // namespace tactics::long_strokes_test
