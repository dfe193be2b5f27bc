// SPDX-License-Identifier: Apache-2.0
// Lettering found by how it stands, read by Tesseract, and taken out without harm to what is beside it.
#include "tactics/lettering/lettering.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "print/format.h"
#include "tactics/lettering/lines.h"
#include "tactics/lettering/strip.h"
#include "tactics/readers/read.h"
#include "tests/cli/tool.h"

namespace tactics::lettering_test {
namespace {

// Blocks that stand as letters do: 8 wide, 12 high, 3 apart, and 9 between words.
void write_blocks(Image& image, int left, int top, const std::string& text, std::uint8_t ink) {
    for (const char c : text) {
        if (c == ' ') {
            left += 6;
            continue;
        }
        for (int y = top; y < top + 12; ++y)
            for (int x = left; x < left + 8; ++x)
                if (x < left + 3 || y > top + 8) image.row(y)[x] = ink;  // an L
        left += 11;
    }
}

Image turned_left(const Image& image) {
    Image out = make_image(image.height, image.width, 1, 0, 255);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) out.row(image.width - 1 - x)[y] = image.row(y)[x];
    return out;
}

TEST(Lettering, IsFoundDarkOnLightAndLightOnDark) {
    for (const bool light : {false, true}) {
        Image image = make_image(200, 60, 1, 0, light ? 40 : 220);
        write_blocks(image, 20, 20, "xxx xx", light ? 200 : 60);
        const auto lines = find_lettering(image);
        ASSERT_EQ(lines.size(), 1u) << light;
        EXPECT_EQ(lines[0].letters.size(), 5u);
        EXPECT_EQ(lines[0].light, light);
        EXPECT_FALSE(lines[0].upwards);
        EXPECT_EQ(lines[0].box, (PixelBox{20, 20, 78, 32}));
        EXPECT_EQ(words_in(lines[0]).least, 2u);
        EXPECT_EQ(words_in(lines[0]).most, 2u);
    }
}

TEST(Lettering, ThatClimbsIsTurnedForReading) {
    Image level = make_image(120, 40, 1, 0, 255);
    write_blocks(level, 20, 12, "xxxx", 0);
    const Image climbing = turned_left(level);
    const auto lines = find_lettering(climbing), straight = find_lettering(level);
    ASSERT_EQ(lines.size(), 1u);
    ASSERT_EQ(straight.size(), 1u);
    EXPECT_TRUE(lines[0].upwards);
    EXPECT_EQ(strip_of(climbing, lines[0], Part::words, 30).pixels, strip_of(level, straight[0], Part::words, 30).pixels);
}

// An A of 20 by 24 pixels with its hole; and boxes.
void fill(Image& image, const PixelBox& box, std::uint8_t ink) {
    for (int y = box.top; y < box.bottom; ++y) std::fill(image.row(y) + box.left, image.row(y) + box.right, ink);
}
void write_a(Image& image, int left, int top) {
    for (int y = 0; y < 24; ++y) {
        const int half = 2 + y / 3;
        fill(image, {left + 10 - half, top + y, left + 13 - half, top + y + 1}, 0);
        fill(image, {left + 7 + half, top + y, left + 10 + half, top + y + 1}, 0);
    }
    fill(image, {left + 6, top + 14, left + 14, top + 17}, 0);
}

TEST(Lettering, HolesOfLettersAreNoLetters) {
    Image image = make_image(160, 60, 1, 0, 255);
    write_a(image, 20, 20);
    auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_FALSE(lines[0].light);
    EXPECT_EQ(lines[0].letter_height, 24);
    // But a light letter on a dark box is one.
    image = make_image(160, 60, 1, 0, 255);
    fill(image, {20, 10, 80, 50}, 40);
    write_blocks(image, 30, 22, "xx", 250);
    lines = find_lettering(image);
    ASSERT_FALSE(lines.empty());
    EXPECT_TRUE(lines[0].light);
    EXPECT_EQ(lines[0].letters.size(), 2u);
}

// Two slanted boxes that stand in line; a letter stands right above the corner of one.
TEST(Lettering, WhatLinesEncloseTakesNoLettersPlace) {
    Image image = make_image(260, 120, 1, 0, 255);
    for (const int left : {20, 100}) {
        for (int i = 0; i < 60; ++i) fill(image, {left + 60 - i, 30 + i, left + 64 - i, 31 + i}, 0);
        for (int i = 0; i < 60; ++i) fill(image, {left + 124 - i, 30 + i, left + 128 - i, 31 + i}, 0);
        fill(image, {left + 60, 28, left + 128, 32}, 0);
        fill(image, {0, 88, 260, 92}, 0);
    }
    write_blocks(image, 106, 38, "x", 0);
    const auto lines = find_lettering(image);
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const LetteringLine& one) { return one.box.left == 106; }));
    EXPECT_TRUE(std::none_of(lines.begin(), lines.end(), [](const LetteringLine& one) { return one.light; }));
}

// A ring on a dark ground, paler above and below, comes apart into two bars where only the darkest counts.
TEST(Lettering, SplintersOfALetterAreNoWord) {
    Image image = make_image(80, 60, 1, 0, 200);
    fill(image, {30, 20, 33, 42}, 30);
    fill(image, {39, 20, 42, 42}, 30);
    fill(image, {33, 20, 39, 22}, 80);
    fill(image, {33, 40, 39, 42}, 80);
    auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].letters.size(), 1u);
    EXPECT_EQ(lines[0].box, (PixelBox{30, 20, 42, 42}));
    fill(image, {33, 20, 39, 42}, 200);  // but two bars are two
    lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].letters.size(), 2u);
}

// As in monospaced print.
// A 5 whose stem is paler than its bar and its bowl; above the other bowl is a tick, which is none of it.
TEST(Lettering, HalvesOfAThinLetterAreOne) {
    const auto line_with = [](bool tick) {
        Image image = make_image(80, 60, 1, 0, 255);
        const auto fill = [&](int left, int top, int right, int bottom, std::uint8_t value) {
            for (int y = top; y < bottom; ++y) std::fill(image.row(y) + left, image.row(y) + right, value);
        };
        fill(31, 18, tick ? 32 : 38, 20, 0);
        fill(31, 20, 32, 23, 150);
        fill(31, 23, 39, 25, 0);
        fill(30, 30, 39, 32, 0);
        fill(37, 23, 39, 32, 0);
        const auto lines = find_lettering(image);
        return lines.empty() ? PixelBox{} : lines.front().box;
    };
    EXPECT_EQ(line_with(false), (PixelBox{30, 18, 39, 32}));
    EXPECT_EQ(line_with(true).top, 23);
}

TEST(Lettering, APointHasAsMuchRoomAsALetter) {
    Image image = make_image(160, 60, 1, 0, 255);
    write_blocks(image, 20, 20, "xx", 0);
    fill(image, {46, 29, 49, 32}, 0);
    write_blocks(image, 56, 20, "x", 0);
    auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].letters.size(), 3u);
    EXPECT_EQ(lines[0].marks.size(), 1u);
    fill(image, {46, 29, 49, 32}, 255);
    EXPECT_EQ(find_lettering(image).size(), 2u) << "without it they are two";
    fill(image, {46, 20, 49, 23}, 0);
    EXPECT_EQ(find_lettering(image).size(), 2u) << "nor is it a point so high up";
}

TEST(Lettering, AMinusSignJoinsWhatIsOnBothSides) {
    const auto letters_with = [](const PixelBox& bar) {  // in the first line
        Image image = make_image(160, 60, 1, 0, 255);
        write_blocks(image, 20, 20, "xx", 0);
        fill(image, bar, 0);
        write_blocks(image, 57, 20, "xx", 0);
        return find_lettering(image).at(0).letters.size();
    };
    EXPECT_EQ(letters_with({45, 25, 53, 27}), 4u);
    EXPECT_EQ(letters_with({45, 38, 53, 40}), 2u) << "a line below";
    EXPECT_EQ(letters_with({45, 25, 47, 27}), 2u) << "a speck";
}

TEST(Lettering, AnEqualsSignIsAsMuchOfALineAsALetter) {
    Image image = make_image(160, 60, 1, 0, 255);
    write_blocks(image, 20, 20, "x", 0);
    fill(image, {34, 24, 43, 26}, 0);
    fill(image, {34, 28, 43, 30}, 0);
    write_blocks(image, 49, 20, "x", 0);
    const auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].letters.size(), 3u);
    EXPECT_EQ(lines[0].box, (PixelBox{20, 20, 57, 32}));
}

TEST(Lettering, AnEqualsSignOfThreeRowsIsALetterToo) {
    Image image = make_image(160, 60, 1, 0, 255);
    write_blocks(image, 20, 20, "x", 0);
    fill(image, {37, 25, 45, 26}, 0);
    fill(image, {37, 27, 45, 28}, 0);
    write_blocks(image, 54, 20, "x", 0);
    const auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].letters.size(), 3u);
    EXPECT_EQ(lines[0].box, (PixelBox{20, 20, 62, 32}));
}

// Of strokes of one pixel, it is less than half as high as the figures of its size.
TEST(Lettering, AFlatEqualsSignIsALetterToo) {
    Image image = make_image(160, 60, 1, 0, 255);
    write_blocks(image, 20, 20, "x", 0);
    for (const int y : {24, 28}) fill(image, {33, y, 44, y + 1}, 0);
    write_blocks(image, 49, 20, "xx", 0);
    for (int y = 18; y < 20; ++y) fill(image, {20, y, 24, y + 1}, 0), fill(image, {49, y, 53, y + 1}, 0);  // 14 pixels high
    const auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].letters.size(), 4u);
}

TEST(Lettering, SamplesOfALegendAreNoEqualsSign) {
    // As far apart as the rows, and beside each a word of that row alone.
    Image image = make_image(160, 80, 1, 0, 255);
    for (const int row : {0, 1}) {
        fill(image, {20, 25 + 22 * row, 50, 27 + 22 * row}, 0);
        write_blocks(image, 58, 20 + 22 * row, "xxxx", 0);
    }
    const auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 2u);
    for (const LetteringLine& line : lines) {
        EXPECT_EQ(line.letters.size(), 4u);
        EXPECT_EQ(line.box.height(), 12);
    }
}

// As diagrams of messages have it: its head reaches the row of the words' feet.
TEST(Lettering, ADottedArrowBelowWordsTakesNothingFromThem) {
    Image image = make_image(200, 60, 1, 0, 255);
    const auto box = [&](int left, int top, int right, int bottom) {
        for (int y = top; y < bottom; ++y) std::fill(image.row(y) + left, image.row(y) + right, std::uint8_t{0});
    };
    for (int i = 0; i < 6; ++i) box(60 + 9 * i, 18, 62 + 9 * i, 30), box(60 + 9 * i, 28, 66 + 9 * i, 30);
    box(40, 29, 45, 38), box(47, 29, 52, 38);  // the halves of its head
    for (int x = 54; x < 130; x += 4) box(x, 33, x + 2, 34);
    const auto lines = find_lettering(image);
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const LetteringLine& line) { return line.letters.size() == 6; }));
}

TEST(Lettering, TicksBelowALineAreNoneOfIt) {
    Image image = make_image(160, 60, 1, 0, 255);
    write_blocks(image, 20, 20, "xxxxx", 0);
    for (const int x : {22, 44, 66}) fill(image, {x, 33, x + 2, 35}, 0);
    const auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].box, (PixelBox{20, 20, 72, 32}));
    EXPECT_TRUE(lines[0].marks.empty());
}

TEST(Lettering, InAFrameAndNumbersBelowEachOtherAreTheirOwnLines) {
    Image image = make_image(200, 120, 1, 0, 255);
    write_blocks(image, 30, 20, "xxx", 0);
    for (int x = 22; x < 70; ++x) image.row(12)[x] = image.row(40)[x] = 0;
    for (int y = 12; y <= 40; ++y) image.row(y)[22] = image.row(y)[69] = 0;
    for (const int row : {0, 1, 2}) write_blocks(image, 120, 20 + 20 * row, "xx", 0);
    const auto lines = find_lettering(image);
    const auto words = std::count_if(lines.begin(), lines.end(), [](const LetteringLine& one) { return one.letters.size() > 1; });
    EXPECT_EQ(words, 4);
    for (const LetteringLine& line : lines) EXPECT_FALSE(line.upwards);
}

// Two cells of a table side by side, one of them empty, stand in line as letters do, and are as clear.
TEST(Lettering, CellsInARowAreNoLetters) {
    for (const bool light : {false, true}) {
        Image image = make_image(200, 80, 1, 0, light ? 0 : 255);
        const std::uint8_t ink = light ? 255 : 0;
        for (const int y : {14, 39}) fill(image, {18, y, 142, y + 2}, ink);
        for (const int x : {18, 79, 140}) fill(image, {x, 14, x + 2, 41}, ink);
        write_blocks(image, 30, 21, "xxx", ink);
        const auto lines = find_lettering(image);
        ASSERT_EQ(lines.size(), 1u) << light;
        EXPECT_EQ(lines[0].box, (PixelBox{30, 21, 60, 33}));
    }
}

// The ground of a legend stands in line with the white of a hatch, and has words in it as a letter has holes.
TEST(Lettering, WordsOnAGroundAreNoHolesOfALetter) {
    Image image = make_image(320, 120, 1, 0, 255);
    fill(image, {10, 14, 260, 94}, 0);
    for (int left = 14; left < 150; left += 34)  // triangles
        for (int y = 0; y < 40; ++y) fill(image, {left, 30 + y, left + (y + 1) * 3 / 4, 31 + y}, 255);
    fill(image, {156, 16, 258, 92}, 255);
    write_blocks(image, 180, 40, "xxxx", 0);
    const auto lines = find_lettering(image);
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const LetteringLine& one) {
        return one.box == PixelBox{180, 40, 221, 52} && !one.light;
    }));
}

TEST(Lettering, OfOneOrTwoLettersMayClimb) {
    Image level = make_image(120, 40, 1, 0, 255);
    write_blocks(level, 20, 12, "xx", 0);
    std::vector<LetteringLine> climbing;
    const auto lines = find_lettering(turned_left(level), &climbing);
    ASSERT_EQ(climbing.size(), 1u);
    EXPECT_TRUE(climbing[0].upwards);
    EXPECT_EQ(climbing[0].letters.size(), 2u);
    for (const LetteringLine& line : lines) EXPECT_FALSE(line.upwards);
}

TEST(Lettering, OfAStripIsAloneAndAsHighAsAsked) {
    Image image = make_image(120, 60, 1, 0, 255);
    write_blocks(image, 20, 20, "xxxx", 30);
    for (int x = 0; x < 120; ++x) image.row(34)[x] = 0;  // an axis, two pixels below
    const auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 1u);
    const Image strip = strip_of(image, lines[0], Part::words, 36);
    int top = strip.height, bottom = 0;
    for (int y = 0; y < strip.height; ++y)
        if (std::any_of(strip.row(y), strip.row(y) + strip.width, [](std::uint8_t v) { return v < 128; })) {
            top = std::min(top, y);
            bottom = y + 1;
        }
    EXPECT_NEAR(bottom - top, 36, 2);
    EXPECT_EQ(*std::min_element(strip.pixels.begin(), strip.pixels.end()), 0);
}

// A finder, and its words as if they were read.
Lettering as_read(const Image& image, const tests::Folder& folder, const std::string& text) {
    const auto path = folder / "reader";
    std::string table = "cat > /dev/null\n";
    for (int page = 1; page <= 2; ++page)
        table += "printf '5\\t" + std::to_string(page) + "\\t1\\t1\\t1\\t1\\t0\\t0\\t9\\t9\\t95\\t" + text + "\\n'\n";
    tests::write_bytes(path, "#!/bin/sh\n" + table);
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return read_lettering(image, "en", kSureEnough, {}, path.string());
}

TEST(Lettering, IsTakenOutAndLinesBesideItStay) {
    const tests::Folder folder;
    Image image = make_image(160, 80, 3, 0, 255);
    Image grey = make_image(160, 80, 1, 0, 200);
    write_blocks(grey, 30, 30, "xxxxx", 20);
    for (int x = 0; x < 160; ++x) grey.row(43)[x] = 20;  // one pixel below the letters
    for (int y = 0; y < 80; ++y) grey.row(y)[28] = 20;   // and beside
    for (std::size_t i = 0; i < grey.pixels.size(); ++i)
        std::fill_n(image.pixels.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, grey.pixels[i]);
    const Lettering lettering = as_read(image, folder, "Lilli");
    ASSERT_EQ(lettering.words.size(), 1u);
    EXPECT_TRUE(lettering.words[0].sure);
    EXPECT_EQ(lettering.words[0].text, "Lilli");
    take_out(image, lettering, true);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 160; ++x) {
            const bool line = y == 43 || x == 28;
            EXPECT_NEAR(image.row(y)[3 * x], line ? 20 : 200, line ? 0 : 60) << x << " " << y;
        }
    // And at half the size.
    Image half = make_image(80, 40, 1, 0, 200);
    for (int y = 15; y < 21; ++y)
        for (int x = 15; x < 43; ++x) half.row(y)[x] = 20;
    take_out(half, lettering, true);
    EXPECT_GT(half.row(20)[16], 150);
}

TEST(Lettering, ReadWithFewerOrMoreWordsThanGapsIsNotSure) {
    const tests::Folder folder;
    Image image = make_image(160, 60, 1, 0, 255);
    write_blocks(image, 30, 20, "xxxxx", 20);
    EXPECT_TRUE(as_read(image, folder, "Lilli").words.at(0).sure);
    EXPECT_FALSE(as_read(image, folder, "Li lli").words.at(0).sure);
}

TEST(Lettering, NothingIsAskedWhereThereIsNone) {
    Image image = make_image(100, 100, 1, 0, 255);
    for (int y = 20; y < 80; ++y) image.row(y)[50] = 0;
    const Lettering lettering = read_lettering(image, "en", kSureEnough, {}, "no-such-program");
    EXPECT_FALSE(lettering.found_any);
    EXPECT_EQ(lettering.trouble.english(), "");
}

TEST(Lettering, OfHostilePicturesIsBounded) {
    // Noise, a fine grid in the size of letters, nothing but letters: a limited number of lines, and termination.
    Image image = make_image(1200, 900, 1, 0, 255);
    std::uint32_t state = 7;
    for (auto& pixel : image.pixels) {
        state = state * 1664525u + 1013904223u;
        pixel = static_cast<std::uint8_t>(state >> 24);
    }
    find_lettering(image);
    for (int y = 0; y < 900; ++y)
        for (int x = 0; x < 1200; ++x) image.row(y)[x] = x % 10 < 6 && y % 14 < 9 ? 0 : 255;
    find_lettering(image);
}

// The real reader on a page of our own print at 100 dpi, as figures have it.
TEST(Lettering, IsReadByTesseract) {
    if (!tests::has_tool("tesseract")) GTEST_SKIP() << "tesseract is not installed";
    Page page;
    page.width = 120;
    page.height = 60;
    page.print = {{{20, 15}, 4.2, "Mean temperature"}, {{20, 30}, 3.6, "17.5"}, {{20, 45}, 3.6, "40"}};
    page.strokes.push_back({{{10, 5}, {10, 55}}, false, 0.3});
    const Format& png = *find_format("png");
    Settings settings(png.options);
    settings.set("dpi", "100", "test", "png");
    const std::string bytes = png.encode(page, settings);
    Source source = memory_source({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, "page.png");
    const Lettering lettering = read_lettering(read_picture(source, {kLookForWords, false}), "en", kSureEnough);
    if (!lettering.trouble.empty()) GTEST_SKIP() << lettering.trouble.english();
    std::vector<std::string> texts;
    for (const PrintedWords& words : lettering.words)
        if (words.sure) texts.push_back(words.text);
    EXPECT_EQ(texts, (std::vector<std::string>{"Mean temperature", "17.5", "40"}));
}

}  // namespace
}  // namespace tactics::lettering_test
