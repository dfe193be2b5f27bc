// SPDX-License-Identifier: Apache-2.0
// Pale surfaces behind curves: left out whole where only scraps of their border would be left.
#include "filters/pale_fills.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/filters/pictures.h"

namespace tactics::pale_fills_test {
namespace {

constexpr std::uint8_t kPale = 210;

double bell(int x) { return 330 - 260 * std::exp(-std::pow((x - 320) / 90.0, 2)); }

// A histogram of bars of 25 pixels, each as high as the curve at its middle plus so much.
Image histogram(double above) {
    Image image = make_image(640, 400, 1, 250.0 / 640, 255);
    for (int x = 70; x < 570; ++x)
        for (int y = std::max(0, static_cast<int>(bell(70 + (x - 70) / 25 * 25 + 12) - above)); y < 330; ++y)
            image.row(y)[x] = kPale;
    for (int x = 40; x < 600; ++x) image.row(330)[x] = 0;
    return image;
}

void draw_curve(Image& image) {
    for (int x = 60; x < 580; ++x)
        for (int y = 1; y < image.height - 1; ++y)
            for (int k = x - 3; k <= x + 3; ++k)
                if (std::hypot(x - k, y - bell(k)) < 3 || (y - bell(k)) * (y - bell(k + 1)) < 0) image.row(y)[x] = 0;
}

std::size_t pale(const Image& image) {
    return static_cast<std::size_t>(std::count(image.pixels.begin(), image.pixels.end(), kPale));
}

TEST(PaleFills, AHistogramBehindItsDensityIsLeftOutWhole) {
    Image image = histogram(0);
    draw_curve(image);
    Image before = image;
    EXPECT_EQ(leave_out_pale_fills(image), 1u);
    EXPECT_EQ(pale(image), 0u);
    // The curve and the axis are as they were.
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const int was = before.pixels[i], is = image.pixels[i];
        ASSERT_TRUE(is == was || (was == kPale && is == 255)) << i;
    }
}

TEST(PaleFills, AloneOrFarFromTheCurveItStays) {
    Image alone = histogram(0), far = histogram(50);
    draw_curve(far);
    for (Image* image : {&alone, &far}) {
        const std::size_t before = pale(*image);
        EXPECT_EQ(leave_out_pale_fills(*image), 0u);
        EXPECT_EQ(pale(*image), before);
    }
}

TEST(PaleFills, ASurfaceWithItsOwnOutlineStays) {
    Image image = make_image(640, 400, 1, 250.0 / 640, 255);
    for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 640; ++x) {
            const double r = std::hypot(x - 320, y - 200);
            if (r < 150) image.row(y)[x] = r > 147 ? 0 : kPale;
        }
    EXPECT_EQ(leave_out_pale_fills(image), 0u);
}

}  // namespace
}  // namespace tactics::pale_fills_test
