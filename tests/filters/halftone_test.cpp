// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/filters/pictures.h"

namespace tactics::halftone_test {
namespace {

using namespace pictures;

constexpr const char* kLines[] = {"halftone", "halftone dot=0mm", "halftone method=ordered", "halftone method=ordered dot=0mm",
                                  "halftone dot=5mm"};

TEST(Halftone, IsBlackAndWhiteAndAsDarkAsThePicture) {
    for (const char* line : {"halftone dot=0mm", "halftone method=ordered dot=0mm", "halftone", "halftone method=ordered"}) {
        for (const int level : {3, 40, 64, 128, 191, 230, 252}) {
            const Image dots = filtered_image(line, make_image(160, 160, 1, kPixel, static_cast<std::uint8_t>(level)));
            EXPECT_EQ(count_level(dots, 0) + count_level(dots, 255), dots.pixels.size());
            EXPECT_NEAR(static_cast<double>(count_level(dots, 255)) / static_cast<double>(dots.pixels.size()), level / 255.0,
                        0.02)
                << line;
        }
    }
}

TEST(Halftone, FollowsAPictureFromPlaceToPlace) {
    for (const char* line : {"halftone dot=0mm", "halftone method=ordered dot=0mm"}) {
        const Image image = drawn(256, 64, [](int x, int) { return x; });
        const Image dots = filtered_image(line, image);
        for (int left = 0; left < 256; left += 16) {
            int white = 0;
            for (int y = 0; y < 64; ++y)
                for (int x = left; x < left + 16; ++x) white += dots.row(y)[x] == 255 ? 1 : 0;
            EXPECT_NEAR(white / (16.0 * 64), (left + 7.5) / 255, 0.04) << line << " at " << left;
        }
    }
}

TEST(Halftone, LeavesBlackAndWhiteAlone) {
    // Blocks of two pixels, the size of a dot.
    const Image image = drawn(40, 30, [](int x, int y) { return (x / 2 * 7 + y / 2 * 3) % 5 < 2 ? 0 : 255; });
    for (const char* line : {"halftone", "halftone dot=0mm", "halftone method=ordered", "halftone method=ordered dot=0mm"})
        EXPECT_EQ(filtered_image(line, image).pixels, image.pixels) << line;
}

TEST(Halftone, MakesNoDotSmallerThanToldTo) {
    for (const char* method : {"diffusion", "ordered"}) {
        const Image dots = filtered_image("halftone dot=0.75mm method=" + std::string(method), random_grey(30, 20, 1));
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 30; ++x) EXPECT_EQ(dots.row(y)[x], dots.row(y / 3 * 3)[x / 3 * 3]);
    }
}

TEST(Halftone, StandsTinyPicturesHugeDotsAndColour) {
    for (const char* line : kLines) {
        for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 9), std::pair(9, 1), std::pair(5, 3)}) {
            for (const Image& image : {random_grey(width, height, 1), random_colour(width, height, 2)}) {
                const Image dots = filtered_image(line, image);
                EXPECT_EQ(dots.channels, 1);
                EXPECT_EQ(count_level(dots, 0) + count_level(dots, 255), static_cast<std::size_t>(width * height));
            }
        }
    }
}

}  // namespace
}  // namespace tactics::halftone_test
