// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/tactics/readers/pictures.h"

namespace tactics::jpeg_test {
namespace {

TEST(Jpeg, GivesThePictureBack) {
    for (const bool progressive : {false, true})
        for (const int channels : {1, 3}) {
            const Image image = test_picture(121, 83, channels);
            const Image read = read_bytes(jpeg_of(image, {.quality = 98, .progressive = progressive}));
            EXPECT_LE(largest_difference(read, image), 6);
        }
}

TEST(Jpeg, GreyIsTheLumaThatItStores) {
    const Image image = test_picture(121, 83, 3);
    for (const auto stored : {JCS_YCbCr, JCS_RGB}) {
        const Image grey = read_bytes(jpeg_of(image, {.quality = 98, .stored = stored}), {});
        EXPECT_EQ(grey.channels, 1);
        EXPECT_LE(largest_difference(grey, to_grey(image)), 4);
    }
}

TEST(Jpeg, ReducedDecodingAgreesWithTheAreaAverage) {
    const Image image = test_picture(403, 301, 3);
    for (const bool colour : {false, true}) {
        const Bytes bytes = jpeg_of(image, {.quality = 98});
        const Image whole = read_bytes(bytes, {.longest = 0, .colour = colour});
        for (const int longest : {402, 250, 202, 201, 150, 101, 60, 51, 20, 1}) {
            const Image small = read_bytes(bytes, {.longest = longest, .colour = colour});
            EXPECT_EQ(std::max(small.width, small.height), longest);
            const Image twin = naive_shrink(whole, small.width, small.height);
            EXPECT_LE(largest_difference(small, twin), 3) << longest;
            EXPECT_NEAR(mean_of(small), mean_of(twin), 0.5) << longest;
        }
    }
}

TEST(Jpeg, EveryOrientationComesUpright) {
    const Image upright = test_picture(40, 24, 1);
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const Bytes bytes = jpeg_of(stored_as(upright, orientation), {.quality = 100, .orientation = orientation});
        EXPECT_LE(largest_difference(read_bytes(bytes), upright), 3) << orientation;
        Source source = memory_source(bytes, "test");
        const PictureInfo info = inspect_picture(source);
        EXPECT_EQ(info.format, "JPEG");
        EXPECT_EQ(info.width, 40);
        EXPECT_EQ(info.height, 24);
        const Image small = read_picture(source, {.longest = 20, .colour = false});  // the same source again
        EXPECT_EQ(small.width, 20);
        EXPECT_EQ(small.height, 12);
    }
}

TEST(Jpeg, InkIsMixedWhetherInvertedOrNot) {
    Image ink = test_picture(64, 48, 4);
    Image expected = make_image(64, 48, 3, 0, 0);
    for (std::size_t i = 0; i < 64 * 48; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            expected.pixels[3 * i + c] =
                static_cast<std::uint8_t>((255 - ink.pixels[4 * i + c]) * (255 - ink.pixels[4 * i + 3]) / 255.0 + 0.5);
    for (const bool adobe : {false, true}) {
        EXPECT_LE(largest_difference(read_bytes(jpeg_of(ink, {.quality = 98, .adobe = adobe})), expected), 5) << adobe;
        EXPECT_LE(largest_difference(read_bytes(jpeg_of(ink, {.quality = 98, .adobe = adobe}), {}), to_grey(expected)), 5);
    }
    EXPECT_LE(largest_difference(read_bytes(jpeg_of(ink, {.quality = 98, .adobe = true, .stored = JCS_YCCK})), expected), 9);
}

TEST(Jpeg, CutShortIsAnErrorWithItsPlace) {
    const Image image = noise_picture(200, 160, 1);
    for (const bool progressive : {false, true}) {
        const Bytes whole = jpeg_of(image, {.quality = 90, .progressive = progressive});
        for (std::size_t size = 4; size < whole.size() - 2; size += 97) {
            const std::string said = complaint(Bytes(whole.begin(), whole.begin() + static_cast<long>(size)));
            EXPECT_TRUE(has(said, "is cut short")) << size << " of " << whole.size() << ": " << said;
        }
        const std::string half = complaint(Bytes(whole.begin(), whole.begin() + static_cast<long>(whole.size() / 2)));
        EXPECT_TRUE(has(half, " of 160")) << half;
        EXPECT_EQ(has(half, "in pass "), progressive) << half;
        if (!progressive) {
            const int line = std::atoi(half.c_str() + half.find("line ") + 5);
            EXPECT_NEAR(line, 80, 12);
        }
    }
}

TEST(Jpeg, OnlyTheEndMarkerMayBeMissing) {
    const Image image = test_picture(64, 48, 1);
    Bytes bytes = jpeg_of(image);
    bytes.erase(bytes.end() - 2, bytes.end());
    EXPECT_LE(largest_difference(read_bytes(bytes), image), 6);
}

TEST(Jpeg, DamagedDataIsAnErrorWithItsPlace) {
    const Bytes whole = jpeg_of(noise_picture(200, 160, 1), {.quality = 90, .restart_rows = 2});
    Bytes ones = whole;  // no code is all ones
    for (std::size_t i = whole.size() / 2; i < whole.size() / 2 + 40; i += 2) ones[i] = 0xFF, ones[i + 1] = 0;
    EXPECT_TRUE(has(complaint(ones), "is damaged at line")) << complaint(ones);
    Bytes swapped = whole;  // the restart markers count
    for (std::size_t i = 600; i + 1 < whole.size(); ++i)
        if (whole[i] == 0xFF && whole[i + 1] == 0xD1) swapped[i + 1] = 0xD6;
    EXPECT_TRUE(has(complaint(swapped), "is damaged at line 33 of 160")) << complaint(swapped);
}

TEST(Jpeg, RefusesPassesWithoutEnd) {
    const Bytes whole = jpeg_of(test_picture(64, 64, 1), {.quality = 50, .progressive = true});
    const auto marker_after = [&](std::size_t at, int wanted) {
        while (whole[at] != 0xFF || whole[at + 1] == 0 || (wanted != 0 && whole[at + 1] != wanted)) ++at;
        return static_cast<long>(at);
    };
    const long scan = marker_after(2, 0xDA), end = marker_after(static_cast<std::size_t>(scan) + 10, 0);
    Bytes bytes(whole.begin(), whole.begin() + end);
    for (int i = 0; i < 300; ++i) bytes.insert(bytes.end(), whole.begin() + scan, whole.begin() + end);
    bytes.insert(bytes.end(), whole.begin() + end, whole.end());
    EXPECT_TRUE(has(complaint(bytes), "too many passes")) << complaint(bytes);
}

TEST(Jpeg, RefusesClaimsWithoutData) {
    Bytes bytes = jpeg_of(test_picture(16, 16, 1), {.progressive = true});
    std::size_t frame = 2;
    while (!(bytes[frame] == 0xFF && bytes[frame + 1] == 0xC2)) ++frame;
    const auto claim = [&](int width, int height) {
        bytes[frame + 5] = static_cast<unsigned char>(height >> 8), bytes[frame + 6] = static_cast<unsigned char>(height);
        bytes[frame + 7] = static_cast<unsigned char>(width >> 8), bytes[frame + 8] = static_cast<unsigned char>(width);
        return complaint(bytes);
    };
    EXPECT_TRUE(has(claim(65500, 65500), "claims 65500 x 65500 pixels"));
    EXPECT_TRUE(has(claim(20000, 20000), "can only be decoded whole"));
    EXPECT_TRUE(has(claim(65500, 0), "is damaged"));
}

}  // namespace
}  // namespace tactics::jpeg_test
