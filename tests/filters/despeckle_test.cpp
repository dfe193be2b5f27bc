#include <gtest/gtest.h>

#include "tests/filters/pictures.h"

namespace tactics {
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

TEST(Despeckle, RemovesShortRidgesAndSmallSpotsOfEdges) {
    EdgeMap edges;
    edges.width = 10;
    edges.height = 3;
    edges.mm_per_pixel = kPixel;
    edges.strength = {5, 5, 5, 5, 5, 5, 0, 9, 9, 0,  //
                      0, 0, 0, 0, 0, 0, 5, 0, 0, 0,  //
                      1, 1, 1, 0, 0, 0, 0, 0, 0, 0};
    EdgeMap ridges = edges;
    ridges.thinned = true;
    // 9 pixels in one piece, 3 in the other: 1 mm is 4 pixels of a ridge, or 12.6 pixels of a spot.
    const auto kept = filtered_edges("despeckle size=1mm", ridges).strength;
    EXPECT_TRUE(std::equal(kept.begin(), kept.begin() + 20, ridges.strength.begin()));
    EXPECT_EQ(std::count(kept.begin() + 20, kept.end(), 0.0f), 10);
    EXPECT_EQ(count_set(filtered_edges("despeckle size=1mm", edges)), 0u);
    EXPECT_EQ(count_set(filtered_edges("despeckle size=0.7mm", edges)), 9u);
}

}  // namespace
}  // namespace tactics
