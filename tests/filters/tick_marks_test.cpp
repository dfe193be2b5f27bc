// SPDX-License-Identifier: Apache-2.0
#include "filters/tick_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace tactics::tick_marks_test {

using Strokes = std::vector<std::array<Point, 2>>;

constexpr double kMm = 0.2;

void fill(Image& picture, int left, int top, int width, int height) {
    for (int y = top; y < top + height; ++y) std::fill_n(picture.row(y) + left, width, std::uint8_t{0});
}

// Its middle is at 200.
Image level_axis() {
    Image picture = make_image(400, 260, 1, kMm, 255);
    fill(picture, 40, 199, 320, 2);
    return picture;
}

// Every `step` pixels, from 40 on.
void ticks(Image& picture, int top, int bottom, int count = 8, int step = 45) {
    for (int i = 0; i < count; ++i) fill(picture, 40 + i * step, top, 2, bottom - top);
}

Image turned(const Image& picture) {
    Image other = make_image(picture.height, picture.width, 1, picture.mm_per_pixel, 255);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) other.row(x)[y] = picture.row(y)[x];
    return other;
}

void expect_ticks(const Strokes& strokes, double from, double to) {
    ASSERT_EQ(strokes.size(), 8u);
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        EXPECT_NEAR(strokes[i][0].x, 41 + 45.0 * static_cast<double>(i), 1);
        EXPECT_NEAR(strokes[i][0].y, from, 0.5);
        EXPECT_NEAR(strokes[i][1].y, to, 0.5);
    }
}

TEST(TickMarks, OfOneSideGoAndTheAxisStays) {
    Image below = level_axis(), above = below;
    const Image bare = below;
    ticks(below, 201, 217);
    ticks(above, 183, 199);
    expect_ticks(take_tick_marks(below), 200, 217);
    expect_ticks(take_tick_marks(above), 183, 200);
    EXPECT_EQ(below.pixels, bare.pixels);
    EXPECT_EQ(above.pixels, bare.pixels);
}

TEST(TickMarks, MayCrossTheirAxis) {
    Image picture = level_axis();
    const Image bare = picture;
    ticks(picture, 185, 215);
    expect_ticks(take_tick_marks(picture), 185, 215);
    EXPECT_EQ(picture.pixels, bare.pixels);
}

TEST(TickMarks, OfAnUprightAxisAreTheSameTurnedOver) {
    Image picture = level_axis();
    ticks(picture, 201, 217);
    Image other = turned(picture);
    const Strokes strokes = take_tick_marks(picture), upright = take_tick_marks(other);
    ASSERT_EQ(upright.size(), strokes.size());
    for (std::size_t i = 0; i < strokes.size(); ++i)
        for (int end = 0; end < 2; ++end) {
            EXPECT_EQ(upright[i][end].x, strokes[i][end].y);
            EXPECT_EQ(upright[i][end].y, strokes[i][end].x);
        }
    EXPECT_EQ(turned(other).pixels, picture.pixels);
}

// Sides of bars, two strokes, marks too near each other, of no length in common, nubs.
TEST(TickMarks, AreAlikeFreeAndApart) {
    std::vector<Image> pictures(5, level_axis());
    ticks(pictures[0], 183, 199);
    for (int i = 0; i < 7; i += 2) fill(pictures[0], 40 + 45 * i, 183, 47, 2);
    ticks(pictures[1], 201, 217, 2);
    ticks(pictures[2], 201, 217, 20, 16);
    for (int i = 0; i < 7; ++i) fill(pictures[3], 40 + 45 * i, 201, 2, 12 + 3 * i);
    ticks(pictures[4], 201, 206);
    for (Image& picture : pictures) {
        const Image before = picture;
        EXPECT_TRUE(take_tick_marks(picture).empty()) << &picture - pictures.data();
        EXPECT_EQ(picture.pixels, before.pixels);
    }
}

TEST(TickMarks, OfALengthMayHaveShorterOnesBetweenThem) {
    Image picture = level_axis();
    ticks(picture, 201, 223);
    for (int i = 0; i < 7; ++i) fill(picture, 62 + 45 * i, 201, 2, 11);
    expect_ticks(take_tick_marks(picture), 200, 223);
}

TEST(TickMarks, OfAnySmallPictureAreNoError) {
    for (const int size : {1, 2, 3, 7}) {
        Image picture = make_image(size, 2 * size, 3, kMm, 0);
        EXPECT_TRUE(take_tick_marks(picture).empty());
    }
}

}  // namespace tactics::tick_marks_test
