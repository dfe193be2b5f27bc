// SPDX-License-Identifier: Apache-2.0
// Bars around a picture go; what only looks like a bar stays.
#include "filters/frame.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "samples/draw/scenes.h"
#include "tests/filters/pictures.h"
#include "tests/tactics/readers/pictures.h"

namespace tactics::frame_test {
namespace {

PixelBox whole(const Image& image) { return all_of(image.width, image.height); }

/// A photograph drawn by the project, in bars of that many pixels (left, top, right, bottom).
Image framed(const Image& picture, const std::array<int, 4>& bars, std::array<std::uint8_t, 3> colour) {
    const int width = picture.width + bars[0] + bars[2], height = picture.height + bars[1] + bars[3];
    Image image = make_image(width, height, 3, 0, 0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int u = x - bars[0], v = y - bars[1];
            const bool inside = u >= 0 && v >= 0 && u < picture.width && v < picture.height;
            for (int c = 0; c < 3; ++c)
                image.row(y)[3 * x + c] =
                    inside ? picture.row(v)[picture.channels * u + c % picture.channels] : colour[static_cast<std::size_t>(c)];
        }
    return image;
}

Image as_jpeg(const Image& image, int quality) {
    JpegKind kind;
    kind.quality = quality;
    const Bytes file = jpeg_of(image, kind);
    Source source = memory_source(file, "framed");
    return read_picture(source, {2000, true});
}

constexpr std::array<std::array<int, 4>, 5> kBars{
    {{0, 30, 0, 30}, {24, 24, 24, 24}, {60, 0, 60, 0}, {0, 0, 0, 40}, {12, 30, 0, 0}}};

// Mottled, and brighter than a bar of black and darker than one of white.
Image mottled(int width, int height) {
    pictures::Chance chance(5);
    return pictures::drawn(width, height,
                           [&](int x, int y) { return 120 + 40 * std::sin(x / 9.0) * std::cos(y / 14.0) + 8 * chance.normal(); });
}

TEST(Frame, IsFoundOnOneToFourSides) {
    const Image picture = mottled(300, 200);
    for (const auto& bars : kBars)
        for (const auto& colour : {std::array<std::uint8_t, 3>{0, 0, 0}, {255, 255, 255}, {240, 232, 210}, {30, 60, 20}}) {
            const Image image = framed(picture, bars, colour);
            EXPECT_EQ(picture_within(image), (PixelBox{bars[0], bars[1], bars[0] + 300, bars[1] + 200}))
                << bars[0] << ' ' << bars[1];
            EXPECT_EQ(picture_within(to_grey(image)), (PixelBox{bars[0], bars[1], bars[0] + 300, bars[1] + 200})) << "grey";
        }
    EXPECT_EQ(picture_within(picture), whole(picture));
}

TEST(Frame, IsFoundInAJpeg) {
    const Image picture = mottled(300, 200);
    for (const auto& bars : kBars)
        for (const int quality : {95, 75, 50}) {
            const PixelBox found = picture_within(as_jpeg(framed(picture, bars, {0, 0, 0}), quality));
            EXPECT_NEAR(found.left, bars[0], 3) << quality;
            EXPECT_NEAR(found.top, bars[1], 3) << quality;
            EXPECT_NEAR(found.width(), 300, 5) << quality;
            EXPECT_NEAR(found.height(), 200, 5) << quality;
        }
}

TEST(Frame, MayBeDouble) {
    const Image inner = framed(mottled(300, 200), {10, 10, 10, 10}, {0, 0, 0});
    EXPECT_EQ(picture_within(framed(inner, {40, 40, 40, 40}, {255, 255, 255})), (PixelBox{50, 50, 350, 250}));
}

TEST(Frame, IsNoNightSky) {
    pictures::Chance chance(3);
    const Image tower = pictures::drawn(400, 300, [](int x, int y) { return y > 120 && std::abs(x - 200) < 30 ? 180 : 5; });
    EXPECT_EQ(picture_within(tower), whole(tower));
    const Image hills =
        pictures::drawn(400, 300, [](int x, int y) { return y > 150 + 12 * std::sin(x / 40.0) ? 90 + x % 40 : 4; });
    EXPECT_EQ(picture_within(hills), whole(hills));
    const Image sloping = pictures::drawn(400, 300, [](int x, int y) { return y > 150 + x / 50 ? 90 + x % 40 : 4; });
    EXPECT_EQ(picture_within(sloping), whole(sloping));
    const Image dusk = pictures::drawn(400, 300, [](int x, int y) { return y < 200 ? y / 4 : 60 + (x * 7 + y * 3) % 90; });
    EXPECT_EQ(picture_within(dusk), whole(dusk));
    const Image noisy = pictures::drawn(400, 300, [&](int x, int y) { return y < 150 ? 20 + 9 * chance.normal() : 90 + x % 40; });
    EXPECT_EQ(picture_within(noisy), whole(noisy));
}

TEST(Frame, IsNoStudio) {
    const Image apple =
        pictures::drawn(400, 300, [](int x, int y) { return std::hypot(x - 200, y - 160) < 90 ? 60 + x / 4 : 255; });
    EXPECT_EQ(picture_within(apple), whole(apple));
    const Image cup = pictures::drawn(
        400, 300, [](int x, int y) { return x > 60 + y / 15 && x < 240 - y / 15 && y > 90 && y < 260 ? 60 + x / 4 : 255; });
    EXPECT_EQ(picture_within(cup), whole(cup));
}

// A page with a box drawn on it has a margin and no frame.
TEST(Frame, IsNoLine) {
    for (const int wide : {1, 3, 6, 9}) {
        const Image box = pictures::drawn(400, 300, [&](int x, int y) {
            const auto within = [&](int by) { return x >= by && x < 400 - by && y >= by && y < 300 - by; };
            return (within(40) && !within(40 + wide)) || std::hypot(x - 200, y - 150) < 20 ? 0 : 255;
        });
        EXPECT_EQ(picture_within(box), whole(box)) << wide;
    }
    for (const char* scene : {"chart", "line-art"}) {
        const Image drawn = samples::draw_scene(scene, 500);
        EXPECT_EQ(picture_within(drawn), whole(drawn)) << scene;
    }
}

TEST(Frame, IsLookedForInAnyShape) {
    for (const auto& [width, height] :
         {std::pair(1, 1), std::pair(1, 700), std::pair(700, 1), std::pair(2, 3), std::pair(501, 3)})
        for (const int channels : {1, 3}) {
            const Image plain = make_image(width, height, channels, 0, 9);
            EXPECT_EQ(picture_within(plain), whole(plain));
        }
    for (int seed = 0; seed < 20; ++seed) {
        const Image random = pictures::random_grey(1 + seed, 21 - seed, static_cast<std::uint64_t>(seed));
        EXPECT_EQ(picture_within(random), whole(random));
    }
}

}  // namespace
}  // namespace tactics::frame_test
