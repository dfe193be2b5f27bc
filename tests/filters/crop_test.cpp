// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tactics/error.h"
#include "tests/filters/pictures.h"

namespace tactics::crop_test {
namespace {

using namespace pictures;

TEST(Crop, KeepsThePixelsAndTheScale) {
    for (const Image& image : {random_grey(20, 10, 1), random_colour(20, 10, 2)}) {
        const Image part = filtered_image("crop left=10 top=20 right=25 bottom=50", image);
        ASSERT_EQ(part.width, 13);
        ASSERT_EQ(part.height, 3);
        EXPECT_EQ(part.channels, image.channels);
        EXPECT_EQ(part.mm_per_pixel, image.mm_per_pixel);
        ASSERT_EQ(part.pixels.size(), part.row_bytes() * 3);
        for (int y = 0; y < 3; ++y)
            for (int i = 0; i < 13 * image.channels; ++i) EXPECT_EQ(part.row(y)[i], image.row(y + 2)[i + 2 * image.channels]);
    }
    const Image image = random_grey(7, 5, 3);
    EXPECT_EQ(filtered_image("crop", image).pixels, image.pixels);
}

TEST(Crop, CutsEdgeMapsWithTheirDirections) {
    EdgeMap edges;
    edges.width = 4;
    edges.height = 2;
    edges.mm_per_pixel = kPixel;
    edges.thinned = true;
    edges.strength = {0, 1, 2, 3, 4, 5, 6, 7};
    edges.normal = {0, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, 0.7f};
    const EdgeMap part = filtered_edges("crop left=50 top=50", edges);
    EXPECT_EQ(part.width, 2);
    EXPECT_EQ(part.height, 1);
    EXPECT_TRUE(part.thinned);
    EXPECT_EQ(part.strength, std::vector<float>({6, 7}));
    EXPECT_EQ(part.normal, std::vector<float>({0.6f, 0.7f}));
    edges.normal.clear();
    EXPECT_TRUE(filtered_edges("crop left=50", edges).normal.empty());
}

TEST(Crop, LeavesAtLeastOnePixelOrSaysSo) {
    for (const char* line :
         {"crop left=90", "crop right=90 bottom=90", "crop left=50 right=49 top=90 bottom=9", "crop left=45 right=45"}) {
        for (const auto& [width, height] : {std::pair(1, 1), std::pair(3, 1), std::pair(1, 2), std::pair(10, 9)}) {
            const Image part = filtered_image(line, random_grey(width, height, 1));
            EXPECT_GE(part.width, 1);
            EXPECT_GE(part.height, 1);
            EXPECT_EQ(part.pixels.size(), part.row_bytes() * static_cast<std::size_t>(part.height));
        }
    }
    try {
        filtered_image("crop left=60 right=40", random_grey(9, 9, 1));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::usage);
        EXPECT_STREQ(error.what(), "crop: left=60 and right=40 leave nothing of the picture (together they must be under 100)");
    }
}

}  // namespace
}  // namespace tactics::crop_test
