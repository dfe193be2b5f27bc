// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstring>

#include "tests/tactics/readers/pictures.h"

namespace tactics::tiff_test {
namespace {

template <class Number>
Bytes bytes_of(const std::vector<Number>& numbers) {
    Bytes bytes(numbers.size() * sizeof(Number));
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

TEST(Tiff, IsExactInEightBitsHoweverItIsStored) {
    for (const int channels : {1, 3})
        for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS})
            for (const int tile : {0, 16, 64})
                for (const bool separate : {false, true}) {
                    const Image image = noise_picture(83, 45, channels);
                    TiffKind kind{.compression = compression, .tile = tile, .separate = separate};
                    EXPECT_EQ(largest_difference(read_bytes(tiff_of(image, kind)), image), 0)
                        << channels << " " << compression << " " << tile << " " << separate;
                    kind.rows_per_strip = 1000;
                    kind.big_endian = true;
                    EXPECT_EQ(largest_difference(read_bytes(tiff_of(image, kind)), image), 0);
                }
}

TEST(Tiff, ShrinksByTheAreaAverage) {
    const Image image = noise_picture(120, 90, 3);
    for (const int tile : {0, 32})
        EXPECT_EQ(largest_difference(read_bytes(tiff_of(image, {.tile = tile}), {.longest = 40, .colour = true}),
                                     naive_shrink(image, 40, 30)),
                  0);
}

TEST(Tiff, ScalesEveryDepth) {
    const std::vector<std::uint16_t> deep = {0, 128, 129, 257, 65535, 32768};
    for (const bool big : {false, true}) {
        TiffKind kind{.bits = 16, .big_endian = big};
        EXPECT_EQ(read_bytes(tiff_of(6, 1, kind, bytes_of(deep))).pixels, (std::vector<std::uint8_t>{0, 0, 1, 1, 255, 128}));
    }
    const std::vector<std::uint32_t> deeper = {0, 0xFFFFFFFFu, 0x80000000u};
    EXPECT_EQ(read_bytes(tiff_of(3, 1, {.bits = 32}, bytes_of(deeper))).pixels, (std::vector<std::uint8_t>{0, 255, 128}));
    EXPECT_EQ(read_bytes(tiff_of(10, 1, {.bits = 1}, {0b10110000, 0b01000000})).pixels,
              (std::vector<std::uint8_t>{255, 0, 255, 255, 0, 0, 0, 0, 0, 255}));
    EXPECT_EQ(read_bytes(tiff_of(4, 1, {.bits = 2}, {0b00011011})).pixels, (std::vector<std::uint8_t>{0, 85, 170, 255}));
    EXPECT_EQ(read_bytes(tiff_of(3, 1, {.bits = 4}, {0x0F, 0x70})).pixels, (std::vector<std::uint8_t>{0, 255, 119}));
    TiffKind white{.bits = 1, .photometric = PHOTOMETRIC_MINISWHITE, .compression = COMPRESSION_CCITTFAX4};
    EXPECT_EQ(read_bytes(tiff_of(8, 1, white, {0b10100000})).pixels,
              (std::vector<std::uint8_t>{0, 255, 0, 255, 255, 255, 255, 255}));
}

TEST(Tiff, TakesDecimalNumbersAsLight) {
    const std::vector<float> light = {0, 1, 0.5f, 2, -1, std::nanf(""), 0.2140f, 0.0f};
    for (const bool separate : {false, true}) {
        const TiffKind kind{.bits = 32, .format = SAMPLEFORMAT_IEEEFP, .separate = separate};
        EXPECT_EQ(read_bytes(tiff_of(8, 1, kind, bytes_of(light))).pixels,
                  (std::vector<std::uint8_t>{0, 255, 188, 255, 0, 0, 127, 0}));
        const TiffKind rgb{
            .bits = 32, .samples = 3, .photometric = PHOTOMETRIC_RGB, .format = SAMPLEFORMAT_IEEEFP, .separate = separate};
        EXPECT_EQ(read_bytes(tiff_of(2, 1, rgb, bytes_of(std::vector<float>{1, 0, 0.5f, 0, 1, 1}))).pixels,
                  (std::vector<std::uint8_t>{255, 0, 188, 0, 255, 255}));
    }
}

TEST(Tiff, LooksUpPalettesOfBothKinds) {
    for (const unsigned scale : {257u, 1u}) {  // 16-bit values as the standard says, 8-bit ones as some programs write
        TiffKind kind{.bits = 4, .photometric = PHOTOMETRIC_PALETTE};
        for (const auto& colour : {std::array{255, 0, 0}, {0, 128, 0}, {9, 8, 7}})
            kind.palette.push_back({static_cast<std::uint16_t>(static_cast<unsigned>(colour[0]) * scale),
                                    static_cast<std::uint16_t>(static_cast<unsigned>(colour[1]) * scale),
                                    static_cast<std::uint16_t>(static_cast<unsigned>(colour[2]) * scale)});
        EXPECT_EQ(read_bytes(tiff_of(3, 1, kind, {0x01, 0x20})).pixels,
                  (std::vector<std::uint8_t>{255, 0, 0, 0, 128, 0, 9, 8, 7}));
    }
}

TEST(Tiff, LaysAlphaOverWhite) {
    const Bytes rows = {100, 50, 0, 255, 0, 0, 0, 0, 51, 0, 51, 51};
    for (const bool separate : {false, true}) {
        TiffKind kind{.samples = 4, .photometric = PHOTOMETRIC_RGB, .separate = separate, .extra = EXTRASAMPLE_UNASSALPHA};
        EXPECT_EQ(read_bytes(tiff_of(3, 1, kind, rows)).pixels,
                  (std::vector<std::uint8_t>{100, 50, 0, 255, 255, 255, 214, 204, 214}));
        kind.extra = EXTRASAMPLE_ASSOCALPHA;
        EXPECT_EQ(read_bytes(tiff_of(3, 1, kind, rows)).pixels,
                  (std::vector<std::uint8_t>{100, 50, 0, 255, 255, 255, 255, 204, 255}));
        kind.extra = EXTRASAMPLE_UNSPECIFIED;  // not alpha: not shown
        EXPECT_EQ(read_bytes(tiff_of(3, 1, kind, rows)).pixels, (std::vector<std::uint8_t>{100, 50, 0, 0, 0, 0, 51, 0, 51}));
    }
    TiffKind grey{.samples = 2, .extra = EXTRASAMPLE_UNASSALPHA};
    EXPECT_EQ(read_bytes(tiff_of(2, 1, grey, {0, 255, 0, 51})).pixels, (std::vector<std::uint8_t>{0, 204}));
}

TEST(Tiff, MixesInk) {
    const TiffKind kind{.samples = 4, .photometric = PHOTOMETRIC_SEPARATED};
    EXPECT_EQ(read_bytes(tiff_of(2, 1, kind, {255, 0, 0, 0, 0, 0, 0, 204})).pixels,
              (std::vector<std::uint8_t>{0, 255, 255, 51, 51, 51}));
}

TEST(Tiff, ReadsJpegInsideAndOtherColourSpaces) {
    const Image image = test_picture(80, 64, 3);
    for (const int tile : {0, 32}) {
        TiffKind kind{.photometric = PHOTOMETRIC_YCBCR, .compression = COMPRESSION_JPEG, .rows_per_strip = 16, .tile = tile};
        EXPECT_LE(largest_difference(read_bytes(tiff_of(image, kind)), image), 16) << tile;
    }
    // CIE L*a*b* by libtiff's own conversion: L = 100, a = b = 0 is white, L = 0 black.
    const TiffKind lab{.samples = 3, .photometric = PHOTOMETRIC_CIELAB};
    const Image read = read_bytes(tiff_of(2, 1, lab, {255, 0, 0, 0, 0, 0}));
    EXPECT_GT(read.pixels[0], 240);
    EXPECT_LT(read.pixels[3], 10);
}

TEST(Tiff, EveryOrientationComesUpright) {
    const Image upright = noise_picture(40, 24, 3);
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const Bytes bytes = tiff_of(stored_as(upright, orientation), {.orientation = orientation});
        EXPECT_EQ(largest_difference(read_bytes(bytes), upright), 0) << orientation;
        Source source = memory_source(bytes, "test");
        EXPECT_EQ(inspect_picture(source).height, 24);
    }
}

TEST(Tiff, CutShortIsAnError) {
    // libtiff writes the directory last, so a file that is cut has none.
    const Bytes whole = tiff_of(noise_picture(60, 50, 3));
    for (const std::size_t size : {whole.size() - 4, whole.size() - 40, whole.size() / 2, std::size_t{12}})
        EXPECT_TRUE(has(complaint(Bytes(whole.begin(), whole.begin() + static_cast<long>(size))), "is cut short")) << size;
}

TEST(Tiff, DamagedDataIsAnErrorEvenWhereTheLibraryOnlyWarns) {
    const Image image = noise_picture(60, 50, 3);
    for (const int compression : {COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_JPEG})
        for (const int tile : {0, 16}) {
            Bytes bytes = tiff_of(image, {.compression = compression, .rows_per_strip = 50, .tile = tile});
            std::fill(bytes.begin() + static_cast<long>(bytes.size() / 4), bytes.begin() + static_cast<long>(bytes.size() / 2),
                      0xFF);
            EXPECT_TRUE(has(complaint(bytes), " at line ")) << compression << " " << tile << complaint(bytes);
        }
}

TEST(Tiff, StripsBehindTheEndAreAnErrorWithTheirLine) {
    // By hand, since libtiff puts the directory behind the data: 4 lines of 4 pixels, of which 10 bytes are there.
    Bytes bytes = {'I', 'I', 42, 0, 8, 0, 0, 0, 8, 0};
    const auto entry = [&](unsigned tag, unsigned value) {
        const Bytes add = {static_cast<unsigned char>(tag),   static_cast<unsigned char>(tag >> 8),   3, 0, 1, 0, 0, 0,
                           static_cast<unsigned char>(value), static_cast<unsigned char>(value >> 8), 0, 0};
        bytes.insert(bytes.end(), add.begin(), add.end());
    };
    const unsigned data = 10 + 8 * 12 + 4;
    entry(256, 4), entry(257, 4), entry(258, 8), entry(259, 1), entry(262, 1), entry(273, data), entry(278, 4), entry(279, 16);
    bytes.insert(bytes.end(), 4, 0);
    Bytes complete = bytes;
    complete.insert(complete.end(), 16, 99);
    EXPECT_EQ(read_bytes(complete).pixels, std::vector<std::uint8_t>(16, 99));
    bytes.insert(bytes.end(), 10, 99);
    EXPECT_TRUE(has(complaint(bytes), "is cut short at line ")) << complaint(bytes);
    EXPECT_TRUE(has(complaint(bytes), " of 4"));
}

TEST(Tiff, RefusesTilesWhoseRowsAreNotWholeBytes) {
    // By hand, since libtiff writes no such file: 100 x 16 pixels of one bit, six tiles, all at one place.
    const auto tiled = [](unsigned tile_width, unsigned tiles) {
        Bytes bytes = {'I', 'I', 42, 0, 8, 0, 0, 0, 10, 0};
        const auto word = [&](unsigned value) {
            bytes.insert(bytes.end(), {Bytes::value_type(value), Bytes::value_type(value >> 8)});
        };
        const auto entry = [&](unsigned tag, unsigned count, unsigned value) {
            for (const unsigned each : {tag, 3u, count, 0u, value, 0u}) word(each);
        };
        const unsigned offsets = 10 + 10 * 12 + 4, data = offsets + 4 * tiles, size = (tile_width + 7) / 8 * 16;
        entry(256, 1, 100), entry(257, 1, 16), entry(258, 1, 1), entry(259, 1, 1), entry(262, 1, 1), entry(277, 1, 1);
        entry(322, 1, tile_width), entry(323, 1, 16), entry(324, tiles, offsets), entry(325, tiles, offsets + 2 * tiles);
        word(0), word(0);
        for (unsigned i = 0; i < tiles; ++i) word(data);
        for (unsigned i = 0; i < tiles; ++i) word(size);
        bytes.insert(bytes.end(), size, 0xFF);
        return bytes;
    };
    EXPECT_EQ(read_bytes(tiled(16, 7)).pixels, std::vector<std::uint8_t>(1600, 255));
    EXPECT_TRUE(has(complaint(tiled(17, 6)), "tiles of an unusual size")) << complaint(tiled(17, 6));
}

TEST(Tiff, RefusesWhatItCannotShow) {
    const TiffKind doubles{.bits = 64, .format = SAMPLEFORMAT_IEEEFP};
    EXPECT_TRUE(has(complaint(tiff_of(1, 1, doubles, Bytes(8))), "64-bit samples"))
        << complaint(tiff_of(1, 1, doubles, Bytes(8)));
    const TiffKind many{.samples = 40, .photometric = PHOTOMETRIC_MINISBLACK};
    EXPECT_TRUE(has(complaint(tiff_of(1, 1, many, Bytes(40))), "40 channels"));
}

TEST(Tiff, RefusesClaimsWithoutData) {
    const auto claimed = [](std::uint32_t width, std::uint32_t height) {
        TiffKind kind;
        Bytes bytes = tiff_of(4, 4, kind, Bytes(16, 50));
        const std::size_t directory = bytes[4] | static_cast<std::size_t>(bytes[5]) << 8;
        for (std::size_t i = directory + 2; i + 12 < bytes.size(); i += 12) {
            const int tag = bytes[i] | bytes[i + 1] << 8;
            if (tag != TIFFTAG_IMAGEWIDTH && tag != TIFFTAG_IMAGELENGTH) continue;
            bytes[i + 2] = 4;  // a long
            const std::uint32_t value = tag == TIFFTAG_IMAGEWIDTH ? width : height;
            for (unsigned b = 0; b < 4; ++b) bytes[i + 8 + b] = static_cast<unsigned char>(value >> (8 * b));
        }
        return complaint(bytes);
    };
    EXPECT_TRUE(has(claimed(65500, 65500), "claims 65500 x 65500 pixels")) << claimed(65500, 65500);
    EXPECT_FALSE(claimed(30000, 30000).empty());
    EXPECT_TRUE(has(claimed(0, 7), "is damaged before its first line"));
}

}  // namespace
}  // namespace tactics::tiff_test
