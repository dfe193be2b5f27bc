// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/filters/pictures.h"

namespace tactics::fill_holes_test {
namespace {

using namespace pictures;

Image hole(double diameter) {
    return drawn(61, 61, [&](int x, int y) { return std::hypot(x - 30, y - 30) * kPixel < diameter / 2 ? 255 : 0; });
}

TEST(FillHoles, FillsHolesByTheirAreaInMillimetres) {
    EXPECT_EQ(count_level(filtered_image("fill-holes size=3mm", hole(2.7)), 0), 61u * 61);
    EXPECT_EQ(filtered_image("fill-holes size=3mm", hole(3.3)).pixels, hole(3.3).pixels);
    EXPECT_EQ(filtered_image("fill-holes size=0.2mm", hole(1)).pixels, hole(1).pixels);
}

TEST(FillHoles, LeavesGroundThatReachesTheEdgeOfThePicture) {
    const Image nick = drawn(9, 9, [](int x, int y) { return x == 4 && y < 2 ? 255 : 0; });
    EXPECT_EQ(filtered_image("fill-holes size=50mm", nick).pixels, nick.pixels);
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 9), std::pair(9, 2)}) {
        const Image image = random_ink(width, height, 1);
        EXPECT_EQ(filtered_image("fill-holes size=50mm", image).pixels, image.pixels);
    }
}

TEST(FillHoles, SeesADiagonalLineAsClosed) {
    // A diamond of pixels that touch by corners only.
    const Image diamond = drawn(11, 11, [](int x, int y) { return std::abs(x - 5) + std::abs(y - 5) == 4 ? 0 : 255; });
    EXPECT_EQ(count_level(filtered_image("fill-holes size=5mm", diamond), 0), 16u + 25u);
}

TEST(FillHoles, OnlyAddsInkAndAddsNothingTheSecondTime) {
    const Image image = random_ink(60, 50, 1, 75);
    const Image once = filtered_image("fill-holes size=1mm", image);
    EXPECT_NE(once.pixels, image.pixels);
    EXPECT_EQ(filtered_image("fill-holes size=1mm", once).pixels, once.pixels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) EXPECT_LE(once.pixels[i], image.pixels[i]);
    EXPECT_EQ(filtered_image("fill-holes", random_colour(5, 5, 1)).channels, 1);
}

}  // namespace
}  // namespace tactics::fill_holes_test
