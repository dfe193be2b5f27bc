// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tactics/units.h"
#include "tests/filters/pictures.h"

namespace tactics::resample_test {
namespace {

using namespace pictures;

Image at_dpi(Image image, double dpi) {
    image.mm_per_pixel = kMmPerInch / dpi;
    return image;
}

TEST(Resample, HasTheResolutionAskedForAndTheSameSizeOnThePage) {
    const Image image = at_dpi(random_grey(301, 120, 1), 300);
    const Image small = filtered_image("resample dpi=150", image);
    EXPECT_EQ(small.width, 151);
    EXPECT_EQ(small.height, 60);
    EXPECT_NEAR(small.width * small.mm_per_pixel, image.width * image.mm_per_pixel, 1e-9);
    EXPECT_NEAR(small.height * small.mm_per_pixel, image.height * image.mm_per_pixel, small.mm_per_pixel);
}

TEST(Resample, NeverEnlarges) {
    const Image image = at_dpi(random_grey(31, 22, 1), 140);
    EXPECT_EQ(filtered_image("resample dpi=150", image).pixels, image.pixels);
    EXPECT_EQ(filtered_image("resample dpi=140", image).pixels, image.pixels);
}

// Every new pixel is the mean of the area of old ones that it covers.
double mean_of_area(const Image& image, int channel, double left, double top, double right, double bottom) {
    double sum = 0;
    for (int y = static_cast<int>(top); y < std::min<double>(image.height, bottom); ++y)
        for (int x = static_cast<int>(left); x < std::min<double>(image.width, right); ++x)
            sum += image.row(y)[x * image.channels + channel] * (std::min(x + 1.0, right) - std::max<double>(x, left)) *
                   (std::min(y + 1.0, bottom) - std::max<double>(y, top));
    return sum / ((right - left) * (bottom - top));
}

TEST(Resample, AveragesAreas) {
    for (const Image& image : {random_grey(60, 40, 1), random_colour(61, 37, 2)}) {
        for (const double dpi : {300.0, 211.0, 700.0}) {
            const Image small = filtered_image("resample dpi=150", at_dpi(image, dpi));
            EXPECT_EQ(small.channels, image.channels);
            const double across = static_cast<double>(image.width) / small.width;
            const double down = static_cast<double>(image.height) / small.height;
            for (int y = 0; y < small.height; ++y)
                for (int x = 0; x < small.width; ++x)
                    for (int c = 0; c < small.channels; ++c)
                        EXPECT_NEAR(small.row(y)[x * small.channels + c],
                                    mean_of_area(image, c, x * across, y * down, (x + 1) * across, (y + 1) * down), 1)
                            << dpi << ": " << x << "," << y;
        }
    }
}

TEST(Resample, KeepsAtLeastOnePixel) {
    const Image line = filtered_image("resample dpi=25", at_dpi(random_grey(100, 1, 1), 1000));
    EXPECT_EQ(line.width, 3);
    EXPECT_EQ(line.height, 1);
    EXPECT_EQ(filtered_image("resample dpi=25", at_dpi(random_grey(1, 1, 1), 2000)).pixels.size(), 1u);
}

}  // namespace
}  // namespace tactics::resample_test
