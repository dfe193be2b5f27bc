// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/filters/pictures.h"

namespace tactics::morphology_test {
namespace {

using namespace pictures;

std::string line(std::string_view operation, std::string_view radius = "1mm") {
    return "morphology operation=" + std::string(operation) + " radius=" + std::string(radius);
}

Image brute_force(const Image& image, double radius, bool darkest) {
    Image result = image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            int level = image.row(y)[x];
            for (int v = 0; v < image.height; ++v)
                for (int u = 0; u < image.width; ++u)
                    if ((u - x) * (u - x) + (v - y) * (v - y) <= radius * radius + 1e-9)
                        level = darkest ? std::min<int>(level, image.row(v)[u]) : std::max<int>(level, image.row(v)[u]);
            result.row(y)[x] = static_cast<std::uint8_t>(level);
        }
    }
    return result;
}

TEST(Morphology, TakesTheDarkestOrLightestOfADisc) {
    for (const Image& image :
         {random_grey(27, 21, 1), random_ink(40, 13, 2, 3), random_grey(33, 1, 3), random_grey(1, 20, 4), random_grey(1, 1, 5)}) {
        for (const double radius : {1.0, 1.5, 2.0, 3.7, 5.0, 12.0, 40.0}) {
            const std::string mm = std::to_string(radius * kPixel) + "mm";
            const Image dark = brute_force(image, radius, true);
            const Image light = brute_force(image, radius, false);
            EXPECT_EQ(filtered_image(line("dilate", mm), image).pixels, dark.pixels) << radius;
            EXPECT_EQ(filtered_image(line("erode", mm), image).pixels, light.pixels) << radius;
            EXPECT_EQ(filtered_image(line("open", mm), image).pixels, brute_force(light, radius, true).pixels) << radius;
            EXPECT_EQ(filtered_image(line("close", mm), image).pixels, brute_force(dark, radius, false).pixels) << radius;
        }
    }
}

TEST(Morphology, KeepsItsLaws) {
    for (const Image& image : {random_grey(50, 40, 1), random_ink(50, 40, 2, 20), random_ink(50, 40, 3, 80)}) {
        const Image opened = filtered_image(line("open"), image);
        const Image closed = filtered_image(line("close"), image);
        EXPECT_EQ(filtered_image(line("open"), opened).pixels, opened.pixels);
        EXPECT_EQ(filtered_image(line("close"), closed).pixels, closed.pixels);
        const Image dilated = filtered_image(line("dilate"), image);
        const Image eroded = filtered_image(line("erode"), image);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            EXPECT_LE(dilated.pixels[i], closed.pixels[i]);
            EXPECT_LE(closed.pixels[i], image.pixels[i]);
            EXPECT_LE(image.pixels[i], opened.pixels[i]);
            EXPECT_LE(opened.pixels[i], eroded.pixels[i]);
        }
    }
}

TEST(Morphology, ActsOnInkInMillimetres) {
    Image image = make_image(40, 40, 1, kPixel, 255);
    image.row(20)[20] = 0;
    // A disc of 1 mm radius is pi mm^2.
    EXPECT_NEAR(static_cast<double>(count_level(filtered_image(line("dilate", "1mm"), image), 0)) * kPixel * kPixel, 3.14, 0.15);
    EXPECT_EQ(count_level(filtered_image(line("open", "0.5mm"), image), 0), 0u);
    image.mm_per_pixel = 1.01;
    EXPECT_EQ(filtered_image(line("dilate", "1mm"), image).pixels, image.pixels);
}

TEST(Morphology, StandsHugeRadiiAndColour) {
    Image image = random_colour(30, 20, 1);
    image.mm_per_pixel = 0.001;  // 10 mm are 10,000 pixels
    const Image result = filtered_image(line("dilate", "10mm"), image);
    EXPECT_EQ(result.channels, 1);
    EXPECT_EQ(std::count(result.pixels.begin(), result.pixels.end(), result.pixels[0]), 600);
}

}  // namespace
}  // namespace tactics::morphology_test
