// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/tactics/readers/pictures.h"

namespace tactics::png_test {
namespace {

// Samples of any width packed from the left, as PNG and TIFF do.
Bytes packed(const std::vector<unsigned>& samples, int bits, int per_row) {
    Bytes bytes;
    for (std::size_t start = 0; start < samples.size(); start += static_cast<std::size_t>(per_row)) {
        unsigned buffer = 0;
        int filled = 0;
        for (std::size_t i = start; i < start + static_cast<std::size_t>(per_row); ++i) {
            buffer = buffer << bits | samples[i];
            for (filled += bits; filled >= 8; filled -= 8) bytes.push_back(static_cast<unsigned char>(buffer >> (filled - 8)));
        }
        if (filled > 0) bytes.push_back(static_cast<unsigned char>(buffer << (8 - filled)));
    }
    return bytes;
}

TEST(Png, IsExactInEightBits) {
    for (const bool interlaced : {false, true})
        for (const int channels : {1, 3})
            for (const Size size : {Size{1, 1}, {37, 29}, {3, 200}}) {
                const Image image = noise_picture(size.width, size.height, channels);
                const Image read = read_bytes(png_of(image, interlaced));
                EXPECT_EQ(largest_difference(read, image), 0) << interlaced << channels;
                EXPECT_EQ(largest_difference(read_bytes(png_of(image, interlaced), {}), to_grey(image)), 0);
            }
}

TEST(Png, ShrinksByTheAreaAverage) {
    const Image image = noise_picture(120, 90, 1);
    EXPECT_EQ(largest_difference(read_bytes(png_of(image), {.longest = 40, .colour = false}), naive_shrink(image, 40, 30)), 0);
    EXPECT_EQ(largest_difference(read_bytes(png_of(image, true), {.longest = 40, .colour = false}), naive_shrink(image, 40, 30)),
              0);
}

TEST(Png, ScalesEveryDepth) {
    for (const int bits : {1, 2, 4, 8, 16})
        for (const bool interlaced : {false, true}) {
            const unsigned largest = (1u << bits) - 1;
            std::vector<unsigned> samples;
            for (unsigned i = 0; i < 13 * 5; ++i) samples.push_back(i * 7919u % (largest + 1));
            const Image read = read_bytes(png_of(13, 5, bits, PNG_COLOR_TYPE_GRAY, packed(samples, bits, 13), interlaced));
            for (std::size_t i = 0; i < samples.size(); ++i)
                EXPECT_EQ(read.pixels[i], static_cast<int>(samples[i] * 255.0 / largest + 0.5)) << bits;
        }
}

TEST(Png, LooksUpPalettesAndTheirTransparency) {
    const png_color colours[] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}};
    const png_byte alphas[] = {255, 0, 51};
    const auto more = [&](png_structp png, png_infop info) {
        png_set_PLTE(png, info, colours, 3);
        png_set_tRNS(png, info, alphas, 3, nullptr);
    };
    const Image read = read_bytes(png_of(3, 1, 2, PNG_COLOR_TYPE_PALETTE, packed({0, 1, 2}, 2, 3), false, more));
    EXPECT_EQ(read.pixels, (std::vector<std::uint8_t>{255, 0, 0, 255, 255, 255, 204, 204, 255}));
}

TEST(Png, LaysAlphaOverWhite) {
    const Bytes grey = {0, 0, 0, 255, 100, 128};
    EXPECT_EQ(read_bytes(png_of(3, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, grey)).pixels, (std::vector<std::uint8_t>{255, 0, 177}));
    const Bytes deep = {0, 0, 0, 0, 0, 0, 0x80, 0x80};  // 16 bits, half covered black
    EXPECT_EQ(read_bytes(png_of(1, 1, 16, PNG_COLOR_TYPE_RGB_ALPHA, deep)).pixels, (std::vector<std::uint8_t>{127, 127, 127}));
    const png_color_16 key = {0, 0, 0, 0, 7};
    const auto more = [&](png_structp png, png_infop info) { png_set_tRNS(png, info, nullptr, 0, &key); };
    EXPECT_EQ(read_bytes(png_of(2, 1, 8, PNG_COLOR_TYPE_GRAY, {7, 8}, false, more)).pixels, (std::vector<std::uint8_t>{255, 8}));
}

TEST(Png, IgnoresGammaAndProfiles) {
    const Image image = test_picture(20, 20, 3);
    const auto more = [&](png_structp png, png_infop info) {
        png_set_gAMA(png, info, 1.0);
        png_set_cHRM(png, info, 0.3, 0.3, 0.6, 0.3, 0.3, 0.6, 0.15, 0.06);
    };
    EXPECT_EQ(largest_difference(read_bytes(png_of(20, 20, 8, PNG_COLOR_TYPE_RGB, image.pixels, false, more)), image), 0);
}

TEST(Png, TurnsUprightByItsExifBlock) {
    const Image upright = noise_picture(11, 6, 1);
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const Image stored = stored_as(upright, orientation);
        Bytes block = exif_block(orientation, false);
        block.erase(block.begin(), block.begin() + 6);
        const auto more = [&](png_structp png, png_infop info) {
            png_set_eXIf_1(png, info, static_cast<png_uint_32>(block.size()), block.data());
        };
        const Bytes bytes = png_of(stored.width, stored.height, 8, PNG_COLOR_TYPE_GRAY, stored.pixels, false, more);
        EXPECT_EQ(largest_difference(read_bytes(bytes), upright), 0) << orientation;
        Source source = memory_source(bytes, "test");
        EXPECT_EQ(inspect_picture(source).width, 11);
    }
}

TEST(Png, CutShortIsAnErrorWithItsPlace) {
    for (const bool interlaced : {false, true}) {
        const Bytes whole = png_of(noise_picture(60, 50, 3), interlaced);
        for (std::size_t size = 8; size + 16 < whole.size(); size += 61) {
            const std::string said = complaint(Bytes(whole.begin(), whole.begin() + static_cast<long>(size)));
            EXPECT_TRUE(has(said, "is cut short")) << size << ": " << said;
        }
        const std::string half = complaint(Bytes(whole.begin(), whole.begin() + static_cast<long>(whole.size() / 2)));
        EXPECT_TRUE(has(half, " of 50")) << half;
    }
}

TEST(Png, DamagedDataIsAnError) {
    Bytes bytes = png_of(noise_picture(60, 50, 3));
    bytes[bytes.size() / 2] ^= 1;
    EXPECT_TRUE(has(complaint(bytes), "is damaged at line"));
    Bytes header = png_of(noise_picture(60, 50, 3));
    header[25] = 77;  // colour type
    EXPECT_TRUE(has(complaint(header), "is damaged before its first line")) << complaint(header);
}

// The claim of another size, with the checksum put right (CRC-32 of ISO 3309, bit by bit).
std::string complaint_of_claim(unsigned width, unsigned height, bool interlaced) {
    Bytes bytes = png_of(test_picture(16, 16, 1), interlaced);
    for (unsigned i = 0; i < 4; ++i) {
        bytes[16 + i] = static_cast<unsigned char>(width >> (24 - 8 * i));
        bytes[20 + i] = static_cast<unsigned char>(height >> (24 - 8 * i));
    }
    std::uint32_t crc = 0xFFFFFFFFu;
    for (std::size_t i = 12; i < 29; ++i) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc % 2 != 0 ? 0xEDB88320u : 0);
    }
    for (unsigned i = 0; i < 4; ++i) bytes[29 + i] = static_cast<unsigned char>(~crc >> (24 - 8 * i));
    return complaint(bytes);
}

TEST(Png, RefusesClaimsWithoutData) {
    EXPECT_TRUE(has(complaint_of_claim(65500, 65500, false), "claims 65500 x 65500 pixels"));
    EXPECT_TRUE(has(complaint_of_claim(2000000000, 1, false), "a side may have at most 200000"));
    EXPECT_TRUE(has(complaint_of_claim(20000, 20000, true), "can only be decoded whole"));
    EXPECT_FALSE(complaint_of_claim(30000, 30000, false).empty());
    EXPECT_FALSE(complaint_of_claim(10000, 10000, true).empty());
}

TEST(Png, ReadsVeryWideAndVeryTall) {
    const Image wide = test_picture(100000, 3, 1), tall = test_picture(3, 100000, 1);
    const Image small = read_bytes(png_of(wide), {.longest = 1000, .colour = false});
    EXPECT_EQ(small.width, 1000);
    EXPECT_EQ(small.height, 1);
    EXPECT_LE(largest_difference(small, naive_shrink(wide, 1000, 1)), 1);
    EXPECT_EQ(largest_difference(read_bytes(png_of(tall)), tall), 0);
}

}  // namespace
}  // namespace tactics::png_test
