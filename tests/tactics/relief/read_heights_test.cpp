// SPDX-License-Identifier: Apache-2.0
// Pictures and height maps of others as heights: what is told, what is taken, what is refused.
#include "tactics/relief/read_heights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "print/height_files.h"
#include "tests/tactics/readers/pictures.h"

namespace tactics::read_heights_test {
namespace {

HeightFile heights(const Bytes& bytes, const HeightWish& wish = {}) {
    Source source = memory_source(bytes, "map");
    return read_heights(source, wish);
}

HeightFile heights(const std::string& bytes, const HeightWish& wish = {}) {
    return heights(Bytes(bytes.begin(), bytes.end()), wish);
}

std::string refusal(const Bytes& bytes, const HeightWish& wish = {}) {
    try {
        heights(bytes, wish);
        return "";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        return error.what();
    }
}

Bytes bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

// A BMP of 24 bits by the format's own description: rows from the bottom, blue first, padded to four bytes.
Bytes bmp_of(const Image& image) {
    const int row = (3 * image.width + 3) / 4 * 4, size = 54 + row * image.height;
    Bytes file = {'B', 'M'};
    const auto add = [&](int value, int bytes) {
        for (int i = 0; i < bytes; ++i) file.push_back(static_cast<unsigned char>(value >> (8 * i)));
    };
    for (const int value : {size, 0, 54, 40, image.width, image.height}) add(value, 4);
    add(1, 2);
    add(24, 2);
    for (const int value : {0, size - 54, 3780, 3780, 0, 0}) add(value, 4);
    for (int y = image.height - 1; y >= 0; --y) {
        for (int x = 0; x < image.width; ++x)
            for (int c = 2; c >= 0; --c) file.push_back(image.row(y)[image.channels == 1 ? x : 3 * x + c]);
        file.resize(file.size() + static_cast<std::size_t>(row - 3 * image.width));
    }
    return file;
}

// As the paper's: 24 bits, black low, white high, evenly.
TEST(ReadHeights, ABitmapIsHighWhereItIsWhite) {
    Image image = make_image(256, 3, 3, 0, 0);
    for (int x = 0; x < 256; ++x)
        for (int c = 0; c < 3; ++c) image.row(1)[3 * x + c] = static_cast<std::uint8_t>(x);
    const HeightFile file = heights(bmp_of(image), {.pitch = 0.5, .low = 0, .high = 40});
    EXPECT_EQ(file.format, "BMP picture");
    EXPECT_TRUE(file.notes.empty());
    EXPECT_EQ(file.map.columns, 256);
    EXPECT_EQ(file.map.rows, 3);
    EXPECT_EQ(file.map.pitch, 0.5);
    for (int x = 0; x < 256; ++x) {
        EXPECT_EQ(file.map.at(x, 0), 0.0f);
        ASSERT_NEAR(file.map.at(x, 1), 40.0 * x / 255, 1e-5);
    }
    const HeightFile mould = heights(bmp_of(image), {.pitch = 0.5, .low = -1, .high = 2, .invert = true});
    EXPECT_NEAR(mould.map.at(0, 1), 2, 1e-6);
    EXPECT_NEAR(mould.map.at(255, 1), -1, 1e-6);
}

TEST(ReadHeights, WhatIsNotToldIsTakenAndSaid) {
    const HeightFile file = heights(bmp_of(make_image(96, 4, 3, 0, 255)));
    ASSERT_EQ(file.notes.size(), 2u);
    EXPECT_EQ(file.notes[0].english(),
              "it tells no pitch: 0.264583 mm, a pixel of a screen, is taken; say what it is with --pitch or --width");
    EXPECT_EQ(file.notes[1].english(),
              "it tells no heights: black is 0 mm and white 10 mm; say what they are with --low and --high");
    EXPECT_NEAR(file.map.width(), 25.4, 1e-9);
    EXPECT_EQ(file.map.at(5, 2), 10.0f);
    EXPECT_NEAR(heights(bmp_of(make_image(96, 4, 3, 0, 255)), {.width = 48}).map.pitch, 0.5, 1e-12);
    // What stands in the file is used, and said if it could mean something else.
    TiffKind kind{.bits = 16};
    const HeightFile deep = heights(tiff_of(3, 1, kind, {0, 0, 0xFF, 0x7F, 0xFF, 0xFF}), {.pitch = 1, .high = 65.535});
    EXPECT_EQ(deep.format, "16-bit TIFF");
    EXPECT_NEAR(deep.map.at(1, 0), 32.767, 1e-5);
    EXPECT_NEAR(deep.map.at(2, 0), 65.535, 1e-5);
    kind.big_endian = true;
    kind.tile = 16;
    EXPECT_EQ(heights(tiff_of(3, 1, kind, {0, 0, 0xFF, 0x7F, 0xFF, 0xFF}), {.pitch = 1, .high = 65.535}).map.heights,
              deep.map.heights);
    kind = {.bits = 16, .photometric = PHOTOMETRIC_MINISWHITE};
    EXPECT_NEAR(heights(tiff_of(3, 1, kind, {0, 0, 0xFF, 0x7F, 0xFF, 0xFF}), {.pitch = 1, .high = 65.535}).map.at(0, 0), 65.535,
                1e-5);
}

TEST(ReadHeights, DecimalNumbersOfOthersAreMillimetresUnlessTheUserSaysWhatTheyAre) {
    const std::vector<float> samples = {100, 150, std::nanf(""), 200};
    Bytes bytes(16);
    std::memcpy(bytes.data(), samples.data(), 16);
    const Bytes tiff = tiff_of(4, 1, {.bits = 32, .format = SAMPLEFORMAT_IEEEFP}, bytes);
    const HeightFile file = heights(tiff, {.pitch = 1});
    EXPECT_EQ(file.map.heights, (std::vector<float>{100, 150, 100, 200}));
    ASSERT_EQ(file.notes.size(), 2u);
    EXPECT_EQ(file.notes[0].english(), "1 sample is no number and counts as the lowest");
    EXPECT_EQ(file.notes[1].english(), "it tells no unit: its numbers are taken as mm; say what they are with --low and --high");
    EXPECT_EQ(heights(tiff, {.pitch = 1, .low = 0, .high = 8}).map.heights, (std::vector<float>{0, 4, 0, 8}));
}

TEST(ReadHeights, TheUsersPitchAndHeightsGoBeforeTheFiles) {
    HeightMap map{3, 2, 0.5, {0, 1, 2, 3, 4, 5}};
    const std::string png = height_png(sheet_of(map, 0, 5), rows_of(map));
    EXPECT_EQ(heights(png).map.pitch, 0.5);
    EXPECT_EQ(heights(png, {.pitch = 2}).map.pitch, 2);
    EXPECT_EQ(heights(png, {.width = 30}).map.pitch, 10);
    EXPECT_NEAR(heights(png, {.low = 10, .high = 20}).map.at(1, 0), 12, 1e-5);
    EXPECT_TRUE(has(refusal(bytes_of(png), {.pitch = 2, .width = 30}), "--width: give this or --pitch"));
    EXPECT_TRUE(has(refusal(bytes_of(png), {.pitch = -1}), "--pitch: a pitch of -1 mm"));
    EXPECT_TRUE(
        has(refusal(bytes_of(png), {.low = 3, .high = 3}), "--high: the highest place, 3 mm, is not over the lowest, 3 mm"));
    EXPECT_TRUE(has(refusal(bytes_of(png), {.low = 3, .high = 1}), "and --invert for a mould"));
    EXPECT_TRUE(has(refusal(bytes_of(png), {.low = 1000, .high = 1001}), "too near each other for so far from zero"));
    EXPECT_TRUE(has(refusal(bytes_of(png), {.high = 1e6}), "up to 100000 mm from zero"));
}

// Other programs keep the words, and put them elsewhere.
TEST(ReadHeights, WordsAreFoundWhereverTheyStandInAPng) {
    HeightMap map{2, 1, 0.5, {0, 5}};
    std::string png = height_png(sheet_of(map, -1, 7), rows_of(map));
    const auto cut = [&](const char* name) {
        const std::size_t at = png.find(name) - 4;
        const std::size_t size = 12 + static_cast<std::size_t>(static_cast<unsigned char>(png[at + 3]));
        const std::string chunk = png.substr(at, size);
        png.erase(at, size);
        return chunk;
    };
    std::string chunks;
    for (int i = 0; i < 3; ++i) chunks += cut("tEXt");
    png.insert(png.find("IEND") - 4, chunks);
    const HeightFile file = heights(png);
    EXPECT_EQ(file.map.pitch, 0.5);
    EXPECT_EQ(file.low, -1);
    EXPECT_EQ(file.high, 7);
    EXPECT_TRUE(file.notes.empty());
}

// Saved again by a program that knows 8 bits only.
TEST(ReadHeights, AMapThatLostItsDepthIsToldOf) {
    HeightMap map{16, 16, 0.5, std::vector<float>(256, 2.0f)};
    const std::string deep = height_png(sheet_of(map, 0, 4), rows_of(map));
    Bytes shallow = png_of(make_image(16, 16, 1, 0, 128));
    std::string words;
    for (std::size_t at = deep.find("tEXt"); at != std::string::npos; at = deep.find("tEXt", at + 4))
        words += deep.substr(at - 4, 12 + static_cast<std::size_t>(static_cast<unsigned char>(deep[at - 1])));
    shallow.insert(shallow.begin() + 33, words.begin(), words.end());
    const HeightFile file = heights(shallow);
    EXPECT_EQ(file.map.pitch, 0.5);
    EXPECT_NEAR(file.map.at(3, 3), 4 * 128 / 255.0, 1e-5);
    ASSERT_EQ(file.notes.size(), 1u);
    EXPECT_TRUE(has(file.notes[0].english(), "256 steps of height are left"));
}

TEST(ReadHeights, HostileMapsAreRefused) {
    HeightMap map{9, 9, 0.5, std::vector<float>(81, 2.0f)};
    const Bytes png = bytes_of(height_png(sheet_of(map, 0, 4), rows_of(map))),
                tiff = bytes_of(height_tiff(sheet_of(map, 0, 4), rows_of(map)));
    for (const Bytes& whole : {png, tiff})
        for (std::size_t size = 1; size + 16 < whole.size(); size += 7)
            EXPECT_NE(refusal(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))), "") << size;
    EXPECT_TRUE(has(refusal({}), "is empty"));
    EXPECT_TRUE(has(refusal(bytes_of("%PDF-1.4 what is this")), "PDF"));
    // A gigabyte of samples is not asked for: the size is judged before.
    Bytes huge = png;
    huge[18] = 0x80;                 // 32768 + 9 columns
    huge[22] = 0x40;                 // 16384 + 9 rows
    const std::uint32_t sum = [&] {  // the header's CRC
        std::uint32_t crc = 0xFFFFFFFFu;
        for (std::size_t i = 12; i < 29; ++i) {
            crc ^= huge[i];
            for (int k = 0; k < 8; ++k) crc = crc >> 1 ^ (crc & 1u ? 0xEDB88320u : 0u);
        }
        return ~crc;
    }();
    for (std::size_t i = 0; i < 4; ++i) huge[29 + i] = static_cast<unsigned char>(sum >> (24 - 8 * i));
    EXPECT_EQ(refusal(huge), "map: has 32777 x 16393 samples; at most 120 million are read, make it smaller first");
    Bytes none = png;
    none[19] = 0;
    EXPECT_NE(refusal(none), "");
    // Words that are nonsense.
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string all(tiff.begin(), tiff.end());
        const std::size_t at = all.find(from);
        EXPECT_NE(at, std::string::npos);
        return bytes_of(all.replace(at, from.size(), to));
    };
    EXPECT_TRUE(has(refusal(with("pitch-mm 0.5", "pitch-mm -.5")), "map: a pitch of -0.5 mm is not from 0.001 mm to 1000 mm"));
    EXPECT_TRUE(has(refusal(with("white-mm 4", "white-mm 0")), "map: the highest place, 0 mm, is not over the lowest, 0 mm"));
    EXPECT_EQ(heights(with("white-mm 4", "white-mm x")).high, kPictureHeight);
}

}  // namespace
}  // namespace tactics::read_heights_test
