// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/filters/pictures.h"

namespace tactics::despeckle_test {
namespace {

using namespace pictures;

// A disc of `diameter` mm.
Image disc(double diameter, int ink, int ground) {
    return drawn(61, 61, [&](int x, int y) { return std::hypot(x - 30, y - 30) * kPixel < diameter / 2 ? ink : ground; });
}

TEST(Despeckle, RemovesSpecksByTheirAreaInMillimetres) {
    EXPECT_EQ(count_level(filtered_image("despeckle size=3mm", disc(2.7, 0, 255)), 255), 61u * 61);
    EXPECT_EQ(filtered_image("despeckle size=3mm", disc(3.3, 0, 255)).pixels, disc(3.3, 0, 255).pixels);
    // Greys stay as they are where nothing is removed.
    const Image grey = disc(3.3, 90, 200);
    EXPECT_EQ(filtered_image("despeckle size=3mm", grey).pixels, grey.pixels);
    const Image ground = disc(2.7, 200, 140);
    EXPECT_EQ(filtered_image("despeckle size=3mm", ground).pixels, ground.pixels);
}

TEST(Despeckle, CountsPixelsThatTouchByCornersAsOne) {
    const Image diagonal = drawn(20, 20, [](int x, int y) { return x == y ? 0 : 255; });
    EXPECT_EQ(filtered_image("despeckle size=1mm", diagonal).pixels, diagonal.pixels);  // 20 pixels, 1 mm is 12.6
    EXPECT_EQ(count_level(filtered_image("despeckle size=1.5mm", diagonal), 0), 0u);    // 28.3
}

TEST(Despeckle, OnlyTakesInkAndTakesNothingNewTheSecondTime) {
    for (const char* size : {"0.2mm", "0.3mm", "1mm", "2mm", "50mm"}) {
        const std::string line = std::string("despeckle size=") + size;
        const Image image = random_ink(60, 50, 1, 35);
        const Image once = filtered_image(line, image);
        EXPECT_EQ(filtered_image(line, once).pixels, once.pixels);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) EXPECT_GE(once.pixels[i], image.pixels[i]);
    }
    const Image image = random_ink(60, 50, 1, 35);
    EXPECT_EQ(filtered_image("despeckle size=0.2mm", image).pixels, image.pixels);  // under a pixel
    EXPECT_EQ(count_level(filtered_image("despeckle size=50mm", image), 0), 0u);
    EXPECT_EQ(count_level(filtered_image("despeckle", random_ink(1, 1, 1, 100)), 255), 1u);
    EXPECT_EQ(filtered_image("despeckle", random_colour(5, 5, 1)).channels, 1);
}

// 1 mm is 4 pixels. A ring of 3 x 3 has 8, but reaches no further than its side: so do letters.
TEST(Despeckle, RemovesPiecesOfEdgesThatDoNotReachFar) {
    EdgeMap edges;
    edges.width = 12;
    edges.height = 6;
    edges.mm_per_pixel = kPixel;
    edges.strength = {0, 0, 0, 0, 0, 5, 5, 5, 5, 0, 0, 5,  //
                      1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 5,  //
                      1, 0, 1, 0, 0, 9, 0, 0, 0, 0, 0, 5,  //
                      1, 1, 1, 0, 0, 0, 9, 0, 0, 0, 0, 5,  //
                      0, 0, 0, 0, 0, 0, 0, 9, 0, 0, 0, 0,  //
                      0, 0, 0, 0, 0, 0, 0, 0, 9, 0, 0, 0};
    for (const bool thinned : {false, true}) {
        edges.thinned = thinned;
        std::vector<float> expected = edges.strength;
        std::replace(expected.begin(), expected.end(), 1.0f, 0.0f);
        EXPECT_EQ(filtered_edges("despeckle size=1mm", edges).strength, expected);
        EXPECT_EQ(filtered_edges("despeckle size=0.75mm", edges).strength, edges.strength);
        EXPECT_EQ(count_set(filtered_edges("despeckle size=1.25mm", edges)), 0u);
    }
}

}  // namespace
}  // namespace tactics::despeckle_test
