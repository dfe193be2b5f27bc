// SPDX-License-Identifier: Apache-2.0
// Filled surfaces of a drawn picture: found, whatever is drawn on and around them, and drawn as closed outlines.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>

#include "filters/known_parts.h"
#include "tests/filters/pictures.h"

namespace tactics::outlined_fills_test {
namespace {

using Colour = std::array<std::uint8_t, 3>;
constexpr Colour kWhite{255, 255, 255}, kBlack{0, 0, 0}, kBlue{60, 60, 200}, kOrange{255, 140, 0};

class Canvas {
public:
    Canvas(int width, int height) : image(make_image(width, height, 3, pictures::kPixel, 255)) {}
    void fill(int left, int top, int right, int bottom, Colour colour) {
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) std::copy(colour.begin(), colour.end(), image.row(y) + 3 * x);
    }
    // With a border of that many pixels, within the box.
    void bar(int left, int top, int right, int bottom, Colour colour, int border) {
        fill(left, top, right, bottom, kBlack);
        fill(left + border, top + border, right - border, bottom - border, colour);
    }
    Image image;
};

bool is_dark_near(const Image& image, int x, int y, int reach) {
    for (int v = std::max(0, y - reach); v <= std::min(image.height - 1, y + reach); ++v)
        for (int u = std::max(0, x - reach); u <= std::min(image.width - 1, x + reach); ++u)
            if (image.row(v)[3 * u] < 100) return true;
    return false;
}

int ink_in(const Image& image, int left, int top, int right, int bottom) {
    int ink = 0;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) ink += image.row(y)[3 * x] < 230 ? 1 : 0;
    return ink;
}

std::set<int> textures_in(const KnownParts& parts) {
    std::set<int> textures;
    for (const Area& area : parts.areas) textures.insert(area.texture);
    return textures;
}

// A frame is no surface, however thick its line, and takes no texture from any.
TEST(OutlinedFills, AFrameAtTheBorderOfThePictureIsNoSurface) {
    for (int frame = 0; frame <= 8; ++frame) {
        Canvas canvas(600, 300);
        canvas.bar(0, 0, 600, 300, kWhite, frame);
        for (int i = 0; i < 5; ++i)
            canvas.bar(20 + 115 * i, 40, 110 + 115 * i, 260, {static_cast<std::uint8_t>(50 * i), 60, 200}, 2);
        const KnownParts parts = take_known_parts(canvas.image, true);
        EXPECT_EQ(parts.areas.size(), 5u) << frame;
        EXPECT_EQ(textures_in(parts).size(), 5u) << frame;
    }
}

TEST(OutlinedFills, AStripAtTheBorderIsAsWideAsItIs) {
    for (const int wide : {28, 60}) {  // 7 mm, too narrow for a texture, and 15
        Canvas canvas(500, 300);
        canvas.fill(0, 0, wide, 300, {200, 60, 60});
        canvas.fill(150, 50, 250, 250, kBlue);
        canvas.fill(300, 50, 400, 250, kOrange);
        EXPECT_EQ(take_known_parts(canvas.image, true).areas.size(), wide * pictures::kPixel < 11 ? 2u : 3u) << wide;
    }
}

// The sides of what fills most of a picture end on white, which is then the ground.
TEST(OutlinedFills, TheGroundIsAroundThemHoweverLargeTheyAre) {
    Canvas canvas(400, 300);
    canvas.fill(12, 12, 388, 150, kBlue);
    canvas.fill(12, 150, 388, 288, kOrange);
    const KnownParts parts = take_known_parts(canvas.image, true);
    EXPECT_EQ(parts.areas.size(), 2u);
    EXPECT_EQ(textures_in(parts).size(), 2u);
}

TEST(OutlinedFills, BarsAreClosedAndStandOnAnAxisThatGoesOn) {
    for (const int border : {0, 1, 2, 3})
        for (const Colour colour : {kBlue, kOrange, kBlack, Colour{211, 211, 211}}) {
            SCOPED_TRACE(int{colour[0]});
            Canvas canvas(400, 300);
            canvas.bar(100, 60, 180, 282, colour, border);
            canvas.bar(180, 120, 260, 282, colour, border);
            canvas.fill(20, 280, 380, 282, kBlack);
            if (border == 0) canvas.fill(180, 120, 182, 280, kWhite);
            Image& picture = canvas.image;
            take_known_parts(picture, true);
            for (int x = 20; x < 380; ++x) EXPECT_TRUE(is_dark_near(picture, x, 281, 2)) << x << ' ' << border;
            for (int x = 101; x < 179; ++x) EXPECT_TRUE(is_dark_near(picture, x, 60, 2)) << x << ' ' << border;
            for (int x = 182; x < 259; ++x) EXPECT_TRUE(is_dark_near(picture, x, 120, 2)) << x << ' ' << border;
            for (int y = 61; y < 280; ++y) EXPECT_TRUE(is_dark_near(picture, 100, y, 2)) << y << ' ' << border;
            for (int y = 121; y < 280; ++y) {
                EXPECT_TRUE((colour == kBlack && border > 0) || is_dark_near(picture, 181, y, 2)) << y << " " << border;
                EXPECT_TRUE(is_dark_near(picture, 259, y, 2)) << y << ' ' << border;
            }
            EXPECT_EQ(ink_in(picture, 108, 68, 172, 274), 0) << border;
            EXPECT_EQ(ink_in(picture, 188, 128, 252, 274), 0) << border;
        }
}

// The line of a mean, or the whisker of an error, in a bar.
TEST(OutlinedFills, WhatIsDrawnOnAFillStays) {
    Canvas canvas(300, 300);
    canvas.bar(100, 60, 200, 280, {180, 200, 240}, 2);
    canvas.fill(149, 20, 151, 120, kBlack);
    canvas.fill(100, 200, 200, 203, kBlack);
    take_known_parts(canvas.image, true);
    for (int y = 20; y < 118; ++y) EXPECT_TRUE(is_dark_near(canvas.image, 150, y, 1)) << y;
    for (int x = 101; x < 199; ++x) EXPECT_TRUE(is_dark_near(canvas.image, x, 201, 1)) << x;
}

TEST(OutlinedFills, AHatchOnAColourIsOneAndItsLinesGo) {
    const auto hatched = [](Canvas& canvas, int left, int right, Colour colour, Colour line, bool dots) {
        canvas.bar(left, 80, right, 282, colour, 2);
        for (int y = 82; y < 280; ++y)
            for (int x = left + 2; x < right - 2; ++x)
                if (dots ? x % 14 < 4 && y % 14 < 4 : (x + y) % 20 < 2) canvas.fill(x, y, x + 1, y + 1, line);
    };
    for (const Colour line : {kBlack, Colour{60, 20, 20}}) {
        Canvas canvas(400, 300);
        canvas.fill(20, 280, 380, 282, kBlack);
        for (int i = 0; i < 2; ++i) {
            hatched(canvas, 60 + 170 * i, 130 + 170 * i, {100, 150, 230}, line, false);
            hatched(canvas, 128 + 170 * i, 198 + 170 * i, kOrange, line, true);
        }
        const KnownParts parts = take_known_parts(canvas.image, true);
        EXPECT_EQ(parts.areas.size(), 4u);
        EXPECT_EQ(textures_in(parts).size(), 2u);
        for (int i = 0; i < 2; ++i) {
            EXPECT_EQ(ink_in(canvas.image, 68 + 170 * i, 90, 120 + 170 * i, 272), 0);
            EXPECT_EQ(ink_in(canvas.image, 138 + 170 * i, 90, 190 + 170 * i, 272), 0);
            for (int y = 82; y < 280; ++y) EXPECT_TRUE(is_dark_near(canvas.image, 129 + 170 * i, y, 2)) << y;
        }
    }
}

// A point of a map is no surface.
TEST(OutlinedFills, APointStaysFilled) {
    Canvas canvas(300, 300);
    for (int y = -12; y <= 12; ++y)
        for (int x = -12; x <= 12; ++x)
            if (x * x + y * y <= 144) canvas.fill(150 + x, 150 + y, 151 + x, 151 + y, kBlack);
    const KnownParts parts = take_known_parts(canvas.image, true);
    ASSERT_EQ(parts.areas.size(), 1u);
    EXPECT_EQ(parts.areas[0].role, Role::symbol);
}

}  // namespace
}  // namespace tactics::outlined_fills_test
