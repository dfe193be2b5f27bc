// SPDX-License-Identifier: Apache-2.0
#include "filters/error_bars.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace tactics::error_bars_test {

using Strokes = std::vector<std::array<Point, 2>>;

constexpr double kMm = 0.2;

using Colour = std::array<std::uint8_t, 3>;

void fill(Image& picture, int left, int top, int width, int height, Colour colour = {0, 0, 0}) {
    for (int y = top; y < top + height; ++y)
        for (int x = left; x < left + width; ++x)
            std::copy_n(colour.begin(), picture.channels, picture.row(y) + x * picture.channels);
}

// A blue bar on white, as plotting tools draw it.
Image bar_chart() {
    Image picture = make_image(300, 240, 3, kMm, 255);
    fill(picture, 100, 120, 80, 100, {31, 119, 180});
    return picture;
}

void outline(Image& picture, int left, int top, int width, int height) {
    fill(picture, left, top, width, 2);
    fill(picture, left, top + height - 2, width, 2);
    fill(picture, left, top, 2, height);
    fill(picture, left + width - 2, top, 2, height);
}

// Upright, through (140, 120).
void error_bar(Image& picture) {
    fill(picture, 139, 90, 2, 60);
    for (const int y : {89, 149}) fill(picture, 128, y, 24, 2);
}

bool has(const Strokes& strokes, Point from, Point to) {
    constexpr double kNear = 2.5;
    return std::any_of(strokes.begin(), strokes.end(), [&](const std::array<Point, 2>& one) {
        return distance(one[0], from) < kNear && distance(one[1], to) < kNear;
    });
}

Image turned(const Image& picture) {
    Image other = make_image(picture.height, picture.width, picture.channels, picture.mm_per_pixel, 255);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            std::copy_n(picture.row(y) + x * picture.channels, picture.channels, other.row(x) + y * picture.channels);
    return other;
}

TEST(ErrorBars, WithCapsGoAndTheBarGoesOnBehindThem) {
    Image picture = bar_chart();
    const Image bare = picture;
    error_bar(picture);
    const Strokes strokes = take_error_bars(picture);
    EXPECT_EQ(strokes.size(), 3u);
    EXPECT_TRUE(has(strokes, {140, 90}, {140, 150}));
    EXPECT_TRUE(has(strokes, {128, 90}, {152, 90}));
    EXPECT_TRUE(has(strokes, {128, 150}, {152, 150}));
    EXPECT_EQ(picture.pixels, bare.pixels);
}

TEST(ErrorBars, OfLevelBarsAreTheSameTurnedOver) {
    Image picture = bar_chart();
    error_bar(picture);
    Image level = turned(picture);
    const Strokes strokes = take_error_bars(picture), other = take_error_bars(level);
    ASSERT_EQ(other.size(), strokes.size());
    for (const auto& [from, to] : strokes) EXPECT_TRUE(has(other, {from.y, from.x}, {to.y, to.x}));
    EXPECT_EQ(turned(level).pixels, picture.pixels);
}

TEST(ErrorBars, WithoutCapsCrossTheEndOfABar) {
    Image picture = bar_chart();
    fill(picture, 139, 90, 2, 60);
    fill(picture, 49, 90, 2, 60);  // crosses nothing, as a letter
    const Strokes strokes = take_error_bars(picture);
    ASSERT_EQ(strokes.size(), 1u);
    EXPECT_TRUE(has(strokes, {140, 90}, {140, 150}));
}

TEST(ErrorBars, OfAnOutlinedWhiteBarLeaveItsOutline) {
    Image picture = make_image(300, 240, 1, kMm, 255);
    outline(picture, 100, 119, 80, 100);
    const Image bare = picture;
    error_bar(picture);
    EXPECT_EQ(take_error_bars(picture).size(), 3u);
    EXPECT_EQ(picture.pixels, bare.pixels);
}

TEST(ErrorBars, AreWhiskersThatBeginAtABox) {
    Image picture = make_image(300, 240, 1, kMm, 255);
    outline(picture, 100, 99, 80, 60);
    fill(picture, 139, 60, 2, 40);
    fill(picture, 120, 59, 40, 2);
    const Strokes strokes = take_error_bars(picture);
    EXPECT_EQ(strokes.size(), 2u);
    EXPECT_TRUE(has(strokes, {140, 60}, {140, 99}));
    EXPECT_TRUE(has(strokes, {120, 60}, {160, 60}));
}

// Sides of bars and of boxes, a T and an I by themselves, an axis with its end.
TEST(ErrorBars, AreNoOtherLines) {
    Image picture = make_image(400, 300, 1, kMm, 255);
    for (int i = 0; i < 4; ++i) outline(picture, 60 + 18 * i, 150, 20, 100);
    fill(picture, 40, 20, 2, 230);
    fill(picture, 40, 248, 340, 2);
    for (const int x : {250, 300}) {
        fill(picture, x, 40, 2, 20);
        fill(picture, x - 8, 39, 18, 2);
    }
    fill(picture, 292, 59, 18, 2);
    fill(picture, 200, 30, 2, 30);  // a t
    fill(picture, 193, 40, 16, 2);
    const Image before = picture;
    EXPECT_TRUE(take_error_bars(picture).empty());
    EXPECT_EQ(picture.pixels, before.pixels);
}

TEST(ErrorBars, HaveCapsAlikeOrFreeEnds) {
    Image picture = bar_chart();
    error_bar(picture);
    fill(picture, 122, 149, 36, 2);  // the lower cap is twice the other
    fill(picture, 166, 80, 2, 70);   // as a 1 or a 7
    fill(picture, 157, 79, 11, 2);
    EXPECT_TRUE(take_error_bars(picture).empty());
}

// The head of an arrow, hollow, which has a base.
TEST(ErrorBars, AreNoArrows) {
    Image picture = make_image(300, 240, 1, kMm, 255);
    outline(picture, 100, 160, 80, 40);
    fill(picture, 139, 90, 2, 70);
    fill(picture, 124, 89, 32, 2);
    for (int i = 0; i < 16; ++i) {
        fill(picture, 124 + i, 89 - 2 * i, 2, 2);
        fill(picture, 154 - i, 89 - 2 * i, 2, 2);
    }
    EXPECT_TRUE(take_error_bars(picture).empty());
}

TEST(ErrorBars, OnTheBorderOfTwoBarsLeaveEachItsColour) {
    Image picture = bar_chart();
    fill(picture, 140, 120, 40, 100, {255, 127, 14});
    const Image bare = picture;
    error_bar(picture);
    EXPECT_EQ(take_error_bars(picture).size(), 3u);
    EXPECT_EQ(picture.pixels, bare.pixels);
}

// As fine as gnuplot draws them, in any size of a picture on its page.
TEST(ErrorBars, MayBeFine) {
    for (const double mm : {0.18, 0.2, 0.22, 0.25, 0.28, 0.32}) {
        Image picture = make_image(300, 240, 1, mm, 255);
        outline(picture, 100, 119, 80, 100);
        fill(picture, 140, 90, 1, 60);
        for (const int y : {90, 149}) fill(picture, 136, y, 9, 1);
        EXPECT_EQ(take_error_bars(picture).size(), 3u) << mm;
    }
}

TEST(ErrorBars, AreNoneOfAHatch) {
    Image picture = make_image(1200, 1200, 1, 0.1, 255);
    for (int y = 20; y < 1160; y += 60) {
        fill(picture, 10, y + 10, 1180, 1);
        for (int x = 12; x < 1188; x += 9) fill(picture, x, y, 1, 20);
    }
    const Image before = picture;
    EXPECT_TRUE(take_error_bars(picture).empty());
    EXPECT_EQ(picture.pixels, before.pixels);
}

TEST(ErrorBars, OfAnySmallPictureAreNoError) {
    for (const int size : {1, 2, 3, 7}) {
        Image picture = make_image(size, 2 * size, 3, kMm, 0);
        EXPECT_TRUE(take_error_bars(picture).empty());
    }
}

}  // namespace tactics::error_bars_test
