// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/filters/pictures.h"

namespace tactics::contrast_test {
namespace {

using namespace pictures;

TEST(Contrast, StretchesToFullBlackAndWhite) {
    const Image image = drawn(101, 3, [](int x, int) { return 80 + x / 2; });  // 80 to 130
    const Image full = filtered_image("contrast black=0 white=100", image);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_EQ(full.pixels[i], std::lround((image.pixels[i] - 80) * 255 / 50.0));
    EXPECT_EQ(filtered_image("contrast black=0 white=100", full).pixels, full.pixels);
}

TEST(Contrast, CutsTheShareOfPixelsThatItWasToldTo) {
    Chance chance(1);
    const Image image = drawn(100, 100, [&](int, int) { return 128 + 20 * chance.normal(); });
    const Image cut = filtered_image("contrast black=5 white=90", image);
    // One grey level of this picture is 2 % of it.
    EXPECT_NEAR(static_cast<double>(count_level(cut, 0)), 500, 200);
    EXPECT_NEAR(static_cast<double>(count_level(cut, 255)), 1000, 200);
}

TEST(Contrast, GammaBrightensTheMiddleAndKeepsTheEnds) {
    const Image image = drawn(256, 1, [](int x, int) { return x; });
    const Image bright = filtered_image("contrast black=0 white=100 gamma=2", image);
    EXPECT_EQ(bright.pixels[0], 0);
    EXPECT_EQ(bright.pixels[64], std::lround(255 * std::sqrt(64 / 255.0)));
    EXPECT_EQ(bright.pixels[255], 255);
    EXPECT_TRUE(std::is_sorted(bright.pixels.begin(), bright.pixels.end()));
}

TEST(Contrast, LeavesPicturesOfOneGreyAlone) {
    for (const int level : {0, 77, 255}) {
        const Image flat = make_image(4, 3, 1, kPixel, static_cast<std::uint8_t>(level));
        EXPECT_EQ(filtered_image("contrast gamma=3", flat).pixels, flat.pixels);
    }
    Image speck = make_image(50, 50, 1, kPixel, 77);
    speck.pixels[0] = 200;  // less than a percentile
    EXPECT_EQ(filtered_image("contrast", speck).pixels, speck.pixels);
}

TEST(Contrast, TreatsTheChannelsOfAColourPictureAlike) {
    Image image = make_image(2, 1, 3, kPixel, 0);
    image.pixels = {50, 50, 50, 150, 150, 150};
    EXPECT_EQ(filtered_image("contrast", image).pixels, std::vector<std::uint8_t>({0, 0, 0, 255, 255, 255}));
    EXPECT_EQ(filtered_image("contrast", random_colour(9, 9, 1)).channels, 3);
}

}  // namespace
}  // namespace tactics::contrast_test
