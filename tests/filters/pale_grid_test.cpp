// SPDX-License-Identifier: Apache-2.0
// Pale grids behind charts in pictures.
#include "filters/pale_grid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "filters/darken.h"
#include "tests/filters/pictures.h"

namespace tactics::pale_grid_test {
namespace {

constexpr std::array<int, 3> kWhite{255, 255, 255};

bool is_curve(int x, int y) { return x > 40 && x < 360 && std::abs(y - 150 - 60 * std::sin(x / 60.0)) < 2; }
bool is_axis(int x, int y) { return (x == 40 && y <= 260) || (y == 260 && x >= 40); }

// Of a chart of 400 x 300 pixels, with an axis at 40 and 260; `behind` gives the level of what is behind it.
Image chart(const std::function<int(int, int)>& behind) {
    return pictures::drawn(400, 300, [&](int x, int y) { return is_curve(x, y) || is_axis(x, y) ? 0 : behind(x, y); });
}

// Every second pixel of four upright lines and of three level ones.
int dotted(int x, int y) {
    const bool upright = x % 80 == 0 && x > 40 && y < 260 && y > 20 && y % 2 == 0;
    const bool level = y % 60 == 20 && y > 40 && y < 260 && x > 40 && x % 2 == 0;
    return upright || level ? 160 : 255;
}

int pale_pixels(const Image& picture) {
    int count = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) count += picture.row(y)[x] > 100 && picture.row(y)[x] < 250 ? 1 : 0;
    return count;
}

TEST(PaleGrid, GoesAndCurvesStay) {
    Image picture = chart(dotted);
    EXPECT_GT(pale_pixels(picture), 900);
    EXPECT_EQ(leave_out_pale_grid(picture, ink_on_white(picture), kWhite), 7u);
    EXPECT_LT(pale_pixels(picture), 40) << "but for the pixels that touch the curve";
    for (int x = 45; x < 355; ++x) EXPECT_LT(picture.row(static_cast<int>(std::lround(150 + 60 * std::sin(x / 60.0))))[x], 100);
}

TEST(PaleGrid, FewUnevenOrDarkLinesSurfacesAndPaleCurvesAreNone) {
    const auto nothing_goes = [](const std::function<int(int, int)>& behind) {
        Image picture = chart(behind);
        const Image before = picture;
        EXPECT_EQ(leave_out_pale_grid(picture, ink_on_white(picture), kWhite), 0u);
        return picture.pixels == before.pixels;
    };
    EXPECT_TRUE(nothing_goes([](int, int) { return 255; }));
    EXPECT_TRUE(nothing_goes([](int x, int y) { return (x == 100 || x == 200) && y < 260 ? 160 : 255; })) << "two";
    EXPECT_TRUE(nothing_goes([](int x, int y) { return (x == 100 || x == 200 || x == 350) && y < 260 ? 160 : 255; })) << "uneven";
    EXPECT_TRUE(nothing_goes([](int x, int y) { return x % 80 == 0 && y < 260 ? 60 : 255; })) << "dark";
    EXPECT_TRUE(nothing_goes([](int x, int y) { return x > 100 && x < 300 && y > 230 && y < 255 ? 200 : 255; })) << "a surface";
    EXPECT_TRUE(nothing_goes([](int x, int y) { return x > 50 && y == 250 - x / 3 ? 180 : 255; })) << "a pale line that leans";
    EXPECT_TRUE(nothing_goes([](int x, int y) { return x > 60 && x < 360 && y > 200 && y < 255 && y % 9 == 0 ? 170 : 255; }))
        << "a hatch";
}

}  // namespace
}  // namespace tactics::pale_grid_test
