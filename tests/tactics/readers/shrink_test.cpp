// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/shrink.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/tactics/readers/pictures.h"

namespace tactics::shrink_test {
namespace {

Image shrink(const Image& image, Size to) {
    RowShrinker<std::uint8_t> shrinker({image.width, image.height}, to, image.channels);
    for (int y = 0; y < image.height; ++y) shrinker.add(image.row(y));
    Image small = make_image(to.width, to.height, image.channels, 0, 0);
    small.pixels = shrinker.take();
    return small;
}

TEST(ShrunkSize, KeepsTheShapeToHalfAPixelAndNeverEnlarges) {
    for (const int longest : {1, 2, 7, 100, 1599, 1600, 1601})
        for (const Size size : {Size{4000, 3000}, {3, 100000}, {100000, 3}, {1, 1}, {1600, 1600}, {4001, 2999}}) {
            const Size to = shrunk_size(size, longest);
            const int longer = std::max(size.width, size.height);
            EXPECT_EQ(std::max(to.width, to.height), std::min(longest, longer));
            const double scale = std::min(1.0, double(longest) / longer);
            EXPECT_LE(std::abs(to.width - std::max(1.0, size.width * scale)), 0.5) << size.width << "x" << size.height;
            EXPECT_LE(std::abs(to.height - std::max(1.0, size.height * scale)), 0.5) << size.width << "x" << size.height;
        }
    EXPECT_EQ(shrunk_size({123, 45}, 0).width, 123);
}

TEST(RowShrinker, IsTheAreaAverage) {
    for (const int channels : {1, 3})
        for (const Size from : {Size{37, 23}, {64, 48}, {5, 91}, {1, 7}}) {
            const Image image = noise_picture(from.width, from.height, channels);
            for (int width = 1; width <= from.width; width += 3)
                for (int height = 1; height <= from.height; height += 5) {
                    const Image small = shrink(image, {width, height});
                    // The twin adds up fractions, and so may miss an exact half. With an odd number of parts there is none.
                    const int parts = from.width / std::gcd(from.width, width) * (from.height / std::gcd(from.height, height));
                    EXPECT_LE(largest_difference(small, naive_shrink(image, width, height)), parts % 2 == 0 ? 1 : 0);
                }
        }
}

TEST(RowShrinker, CountsAPartlyFilledEdgeByItsShare) {
    const Image image = noise_picture(9, 7, 1);
    const Size eighths{8 * 8 + 3, 6 * 8 + 5};
    Image fine = make_image(eighths.width, eighths.height, 1, 0, 0);  // eighths of pixels are its pixels
    for (int y = 0; y < fine.height; ++y)
        for (int x = 0; x < fine.width; ++x) fine.row(y)[x] = image.row(y / 8)[x / 8];
    for (const Size to : {Size{8, 6}, {5, 4}, {3, 1}}) {
        RowShrinker<std::uint8_t> shrinker({9, 7}, to, 1, eighths);
        for (int y = 0; y < 7; ++y) shrinker.add(image.row(y));
        Image small = make_image(to.width, to.height, 1, 0, 0);
        small.pixels = shrinker.take();
        EXPECT_LE(largest_difference(small, naive_shrink(fine, to.width, to.height)), 1);
    }
}

TEST(RowShrinker, IsExactWhereWholePixelsMeet) {
    const Image image = noise_picture(96, 60, 3);
    for (const Size to : {Size{96, 60}, {32, 20}, {1, 1}, {96, 1}, {1, 60}})
        EXPECT_EQ(largest_difference(shrink(image, to), naive_shrink(image, to.width, to.height)), 0);
}

TEST(RowShrinker, KeepsTheMean) {
    const Image image = noise_picture(400, 300, 1);
    // At 2:1 a quarter of the sums ends on one half, which is rounded up: 1/8 too bright.
    for (const Size to : {Size{399, 299}, {200, 150}, {137, 101}, {3, 3}})
        EXPECT_NEAR(mean_of(shrink(image, to)), mean_of(image), to.width > 100 ? 0.15 : 0.5);
}

TEST(RowShrinker, DoesNotOverflowAtTheLargestSide) {
    const int side = kMaxSide;
    RowShrinker<std::uint8_t> wide({side, 1}, {side - 1, 1}, 1);
    const std::vector<std::uint8_t> white(static_cast<std::size_t>(side), 255);
    wide.add(white.data());
    for (const auto sample : wide.take()) ASSERT_EQ(sample, 255);
    RowShrinker<std::uint8_t> tall({1, side}, {1, side - 1}, 1);
    for (int y = 0; y < side; ++y) tall.add(white.data());
    for (const auto sample : tall.take()) ASSERT_EQ(sample, 255);
}

TEST(RowShrinker, AveragesFloatsToo) {
    RowShrinker<float> shrinker({3, 2}, {2, 1}, 1);
    const float rows[2][3] = {{1, 2, 4}, {3, 6, 8}};
    for (const auto& row : rows) shrinker.add(row);
    const auto mean = shrinker.take();
    ASSERT_EQ(mean.size(), 2u);
    EXPECT_FLOAT_EQ(mean[0], (1 + 3 + 0.5f * (2 + 6)) / 3);
    EXPECT_FLOAT_EQ(mean[1], (4 + 8 + 0.5f * (2 + 6)) / 3);
}

}  // namespace
}  // namespace tactics::shrink_test
