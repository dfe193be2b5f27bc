// SPDX-License-Identifier: Apache-2.0
// Ink of any colour.
#include "filters/darken.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "tests/filters/pictures.h"

namespace tactics::darken_test {
namespace {

constexpr double kPixel = 0.17;  // mm: 150 dpi

Image coloured(std::array<std::uint8_t, 3> ground, std::array<std::uint8_t, 3> line) {
    Image image = make_image(60, 40, 3, kPixel, 0);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) image.row(y)[3 * static_cast<std::size_t>(x) + c] = (y == 20 ? line : ground)[c];
    return image;
}

TEST(Darken, ColouredLinesAreDarkAndTheGroundIsWhite) {
    const std::array<std::uint8_t, 3> white{255, 255, 255}, black{0, 0, 0}, yellow{255, 220, 0}, cream{250, 245, 220},
        sky{86, 180, 233}, chalk{240, 250, 190}, blueprint{91, 155, 213}, board{150, 190, 150};
    for (const auto& [ground, line] : {std::pair{white, yellow},
                                       {white, sky},
                                       {white, black},
                                       {black, white},
                                       {black, chalk},
                                       {cream, sky},
                                       {blueprint, white},
                                       {blueprint, black},
                                       {board, cream}}) {
        const Image ink = pictures::filtered_image("darken", coloured(ground, line));
        ASSERT_EQ(ink.channels, 1);
        EXPECT_GE(ink.row(5)[5], 250);
        EXPECT_LT(ink.row(20)[5], 160);
    }
}

// A chart whose margins are cut off.
TEST(Darken, PaperIsTheGroundThoughMoreIsPaintedInOneColour) {
    const Image picture = pictures::drawn(100, 100, [](int x, int) { return x < 40 ? 255 : x < 90 ? 60 : 120; });
    EXPECT_EQ(ground_of(picture), (std::array<int, 3>{255, 255, 255}));
    const Image shade = pictures::drawn(100, 100, [](int x, int) { return x < 40 ? 240 : x < 90 ? 180 : 60; });
    EXPECT_EQ(ground_of(shade), (std::array<int, 3>{180, 180, 180}));
    const Image board = pictures::drawn(100, 100, [](int x, int) { return x < 10 ? 255 : x < 90 ? 30 : 120; });
    EXPECT_EQ(ground_of(board), (std::array<int, 3>{30, 30, 30}));
}

// Pixel by pixel, as the header says it.
TEST(Darken, InkIsTheChannelThatIsFarthestFromTheGround) {
    std::mt19937 random(5);
    for (const int channels : {1, 3})
        for (int turn = 0; turn < 20; ++turn) {
            Image picture = make_image(37, 23, channels, kPixel, 255);
            for (std::size_t i = 0; i < 100; ++i)
                picture.pixels[random() % picture.pixels.size()] = static_cast<std::uint8_t>(random());
            for (int x = 5; x < 5 + turn; ++x) std::fill_n(picture.row(9) + x * channels, channels, std::uint8_t{40});
            const std::array<int, 3> ground = ground_of(picture);
            const Image ink = ink_on_white(picture);
            const std::vector<Image> inks = inks_on_white(picture);
            ASSERT_EQ(inks.size(), static_cast<std::size_t>(channels));
            for (int y = 0; y < picture.height; ++y)
                for (int x = 0; x < picture.width; ++x) {
                    int most = 0;
                    for (int c = 0; c < channels; ++c) {
                        const int off = std::max(0, ground[static_cast<std::size_t>(c)] - picture.row(y)[x * channels + c]);
                        EXPECT_EQ(inks[static_cast<std::size_t>(c)].row(y)[x], 255 - off) << x << " " << y;
                        most = std::max(most, off);
                    }
                    EXPECT_EQ(ink.row(y)[x], 255 - most) << x << " " << y;
                }
        }
}

// As a camera sees paper: what is lighter than most of it is no ink.
TEST(Darken, LighterPaperIsNoInk) {
    Image image = make_image(400, 40, 1, kPixel, 190);
    for (int y = 0; y < image.height; ++y)
        for (int x = 250; x < 400; ++x) image.row(y)[x] = static_cast<std::uint8_t>(std::min(255, 190 + (x - 250) / 2));
    for (int y = 10; y < 30; ++y) image.row(y)[100] = 90;
    const Image ink = pictures::filtered_image("darken", image);
    EXPECT_EQ(ink.row(20)[390], 255);
    EXPECT_LT(ink.row(20)[100], 200);
}

}  // namespace
}  // namespace tactics::darken_test
