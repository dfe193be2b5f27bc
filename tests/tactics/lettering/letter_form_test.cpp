// SPDX-License-Identifier: Apache-2.0
// Shapes of letters, and ink that is held against them.
#include "tactics/lettering/letter_form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tactics/lettering/form_reader.h"
#include "tactics/lettering/ink_letters.h"

namespace tactics::letter_form_test {
namespace {

std::vector<Point> box(double left, double bottom, double right, double top) {
    return {{left, bottom}, {left, top}, {right, top}, {right, bottom}};
}
std::vector<Point> hole(double left, double bottom, double right, double top) {
    return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

// Letters that a font of strokes could have: L, an O with a hole, a lower o, an i, a minus sign.
FontShapes strokes() {
    return {{U'L', {0.7, {box(0.1, 0, 0.2, 0.7), box(0.2, 0, 0.6, 0.1)}}},
            {U'O', {0.8, {box(0.1, 0, 0.7, 0.7), hole(0.2, 0.1, 0.6, 0.6)}}},
            {U'o', {0.6, {box(0.05, 0, 0.5, 0.5), hole(0.15, 0.1, 0.4, 0.4)}}},
            {U'i', {0.3, {box(0.1, 0, 0.2, 0.5), box(0.1, 0.6, 0.2, 0.7)}}},
            {0x2212, {0.8, {box(0.1, 0.3, 0.7, 0.4)}}}};
}

TEST(LetterForm, TellsHowMuchOfEachPartIsInk) {
    LetterForm form(strokes().at(U'O'));
    form.draw(strokes().at(U'O'));
    EXPECT_DOUBLE_EQ(form.width(), 0.6);
    EXPECT_DOUBLE_EQ(form.height(), 0.7);
    const double whole = 1 - 0.4 * 0.5 / (0.6 * 0.7);
    EXPECT_NEAR(form.ink_before(1, 1), whole, 0.02);
    EXPECT_NEAR(form.ink_before(0.5, 1), whole / 2, 0.02);    // left half
    EXPECT_NEAR(form.ink_before(1, 1.0 / 7), 1.0 / 7, 0.02);  // the stroke above
    EXPECT_EQ(form.ink_before(0, 1), 0);
    EXPECT_TRUE(LetterForm(FontShape{0.3, {}}).empty());
}

// Whether a ring of the shape runs around that place, side by side.
bool is_within(const FontShape& shape, double x, double y) {
    int winding = 0;
    for (const auto& ring : shape.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            const double side = (b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y);
            if (a.y <= y && b.y > y && side > 0) ++winding;
            if (a.y > y && b.y <= y && side < 0) --winding;
        }
    return winding != 0;
}

TEST(LetterForm, FillsSlantedShapesAsANaiveTwinDoes) {
    const FontShape shapes[] = {{0.7, {{{0.1, -0.2}, {0.31, 0.63}, {0.62, 0.1}}}},                                  // a triangle
                                {0.7, {{{0.1, 0}, {0.3, 0.7}, {0.4, 0.7}, {0.2, 0}}, box(0.15, 0.3, 0.6, 0.35)}},   // crossed
                                {0.7, {{{0, 0}, {0.2, 0.5}, {0.5, 0.4}, {0.05, 0.33}, {0.4, 0.07}, {0.3, -0.1}}}},  // a bent one
                                {0.9, {{{0, 0}, {0.8, 0.02}, {0.8, 0.05}, {0, 0.03}}}}};                            // a low one
    for (const FontShape& shape : shapes) {
        LetterForm form(shape);
        form.draw(shape);
        // Square by square of the grid on which forms are drawn, by its middle.
        constexpr double kSquares = 96;  // of an em
        const int columns = static_cast<int>(std::ceil(form.width() * kSquares)),
                  rows = static_cast<int>(std::ceil(form.height() * kSquares));
        for (const int across : {columns, columns / 2, columns / 3})
            for (const int down : {rows, rows / 2, rows / 5 + 1}) {
                int inside = 0;
                for (int y = 0; y < down; ++y)
                    for (int x = 0; x < across; ++x)
                        inside += is_within(shape, form.left() + (x + 0.5) / columns * form.width(),
                                            form.top() - (y + 0.5) / rows * form.height());
                constexpr double kTies = 5e-4;
                EXPECT_NEAR(form.ink_before(1.0 * across / columns, 1.0 * down / rows), 1.0 * inside / (columns * rows), kTies)
                    << across << " " << down;
            }
    }
}

// Paints a text at that size into a picture as a program does that fades the edges of its letters; a naive twin that asks, for
// parts of each pixel, whether they are within.
void write(Image& image, double left, double foot, double em, std::u32string_view text) {
    const FontShapes font = strokes();
    constexpr int kParts = 4;
    for (const char32_t code : text) {
        if (code == U' ') {
            left += 0.4 * em;
            continue;
        }
        const FontShape& shape = font.at(code);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                int inside = 0;
                for (int part = 0; part < kParts * kParts; ++part) {
                    const double px = (x + (part % kParts + 0.5) / kParts - left) / em,
                                 py = (foot - y - (part / kParts + 0.5) / kParts) / em;
                    int winding = 0;
                    for (const auto& ring : shape.rings) {
                        const bool in = px > ring[0].x && px < ring[2].x && py > std::min(ring[0].y, ring[2].y) &&
                                        py < std::max(ring[0].y, ring[2].y);
                        winding += in ? (ring[1].x == ring[0].x ? 1 : -1) : 0;
                    }
                    inside += winding != 0;
                }
                std::uint8_t& pixel = image.row(y)[x];
                pixel = static_cast<std::uint8_t>(pixel * (kParts * kParts - inside) / (kParts * kParts));
            }
        left += shape.advance * em;
    }
}

std::string read(std::u32string_view text, double em, const std::vector<double>& known = {}) {
    Image image = make_image(260, 60, 1, 0, 255);
    write(image, 20.3, 40.6, em, text);
    const auto lines = find_lettering(image);
    if (lines.size() != 1) return std::to_string(lines.size()) + " lines";
    FormFont font(strokes());
    const FormReading reading = read_by_forms(InkStrip(image, lines[0]), font, known);
    EXPECT_NEAR(reading.em, em, 0.06 * em) << reading.text;
    return reading.text;
}

TEST(LetterInk, IsGivenUpOnlyIfItIsLessAlikeThanAsked) {
    FormFont font(strokes());
    std::size_t kept = 0, given_up = 0;
    for (const double em : {9.0, 13.3, 20.0, 41.0}) {
        Image image = make_image(300, 60, 1, 0, 255);
        write(image, 20.3, 40.6, em, U"LiOoL\u2212Oi");
        const auto lines = find_lettering(image);
        ASSERT_FALSE(lines.empty()) << em;
        const InkStrip strip(image, lines[0]);
        for (std::size_t first = 0; first < strip.units(); ++first)
            for (std::size_t last = first; last < std::min(first + 2, strip.units()); ++last)
                for (const auto& [code, shape] : font.shapes()) {
                    LetterInk ink(strip, first, last, strip.measure(first, last));
                    const double whole = ink.likeness(font.drawn(code));
                    for (const double least : {0.2, 0.4, 0.6, 0.8, 0.95, whole, whole - 0.01, whole + 0.01}) {
                        const double said = ink.likeness(font.drawn(code), least);
                        if (whole >= least)
                            EXPECT_EQ(said, whole) << em << " " << first << " " << last << " " << least;
                        else
                            EXPECT_LT(said, least) << em << " " << first << " " << last << " " << least;
                        ++(whole >= least ? kept : given_up);
                    }
                }
    }
    EXPECT_GT(kept, 100u);
    EXPECT_GT(given_up, 100u);
}

// Whatever pixels it lies on.
TEST(InkStrip, AStemIsAsWideAsItIs) {
    constexpr double kEm = 13;
    for (int part = 0; part < 8; ++part) {
        Image image = make_image(200, 60, 1, 0, 255);
        write(image, 20 + part / 8.0, 40, kEm, U"LiL");
        const auto lines = find_lettering(image);
        ASSERT_EQ(lines.size(), 1u);
        const InkStrip strip(image, lines[0]);
        ASSERT_EQ(strip.units(), 3u);
        EXPECT_NEAR(strip.measure(1, 1).width(), 0.1 * kEm, 0.26) << part << "; a part of a pixel is a quarter";
        EXPECT_NEAR(strip.measure(0, 0).width(), 0.5 * kEm, 0.5) << part;
    }
}

TEST(FormReader, ReadsLettersOfAFontAtAnySizeAndKnowsItsSpaces) {
    for (const double em : {18.0, 21.7, 30.0, 44.0}) {
        EXPECT_EQ(read(U"LiOo", em), "LiOo") << em;
        EXPECT_EQ(read(U"LO oi", em), "LO oi") << em;
    }
}

TEST(FormReader, SmallAndLargeLettersAreToldBySizesThatAreKnown) {
    EXPECT_EQ(read(U"oo", 30, {30}), "oo");
    Image image = make_image(200, 60, 1, 0, 255);
    write(image, 20, 40, 30, U"L");
    FormFont font(strokes());
    const auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_GT(read_by_forms(InkStrip(image, lines[0]), font, {}).least, 0.9);
    EXPECT_EQ(read_by_forms(InkStrip(image, lines[0]), font, {}).text, "L");
}

// An L and a smaller one above the line, as a font has raised figures.
// Both sizes are known; bent to pixels, either is more like itself by accident.
TEST(FormReader, ALetterAloneMayBeOfEitherSize) {
    Image image = make_image(100, 60, 1, 0, 255);
    write(image, 20.3, 40.6, 28, U"o");
    const auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 1u);
    FormFont font(strokes());
    const InkStrip strip(image, lines[0]);
    EXPECT_TRUE(read_by_forms(strip, font, {20, 28}).either);
    EXPECT_FALSE(read_by_forms(strip, font, {28}).either);
}

TEST(FormReader, WhatBeginsALineIsNotRaised) {
    FontShapes shapes = strokes();
    shapes[U'\u00b9'] = {0.42, {box(0.06, 0.28, 0.12, 0.7), box(0.12, 0.28, 0.36, 0.34)}};
    FormFont font(shapes);
    Image image = make_image(200, 60, 1, 0, 255);
    write(image, 20, 40, 18, U"L");
    const auto alone = find_lettering(image);
    ASSERT_EQ(alone.size(), 1u);
    const FormReading reading = read_by_forms(InkStrip(image, alone[0]), font, {30});
    EXPECT_EQ(reading.text, "L");
    EXPECT_NEAR(reading.em, 18, 1);
    image = make_image(200, 60, 1, 0, 255);
    write(image, 20, 40, 30, U"L");
    write(image, 41, 31.6, 18, U"L");
    const auto power = find_lettering(image);
    ASSERT_EQ(power.size(), 1u);
    EXPECT_EQ(read_by_forms(InkStrip(image, power[0]), font, {30}).text, "L\u00b9");
}

TEST(FormReader, LettersThatTouchAreFoundByWhatTheyMaySay) {
    Image image = make_image(200, 60, 1, 0, 255);
    write(image, 20, 40, 30, U"LO");
    for (int x = 30; x < 48; ++x) image.row(38)[x] = image.row(39)[x] = 0;  // the foot of the L reaches the O
    const auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 1u);
    const InkStrip strip(image, lines[0]);
    ASSERT_EQ(strip.units(), 1u);
    FormFont font(strokes());
    EXPECT_EQ(read_by_forms(strip, font, {}).text, "");
    EXPECT_EQ(read_by_forms(strip, font, {}, "LO").text, "LO");
    EXPECT_EQ(read_by_forms(strip, font, {}, "oi").text, "");
}

// A dash of less than a pixel lies on two rows, neither of which is dark.
TEST(FormReader, AThinDashIsOne) {
    FontShapes shapes = strokes();
    shapes[0x2212] = {0.8, {box(0.1, 0.33, 0.7, 0.37)}};
    FormFont font(shapes);
    Image image = make_image(200, 60, 1, 0, 255);
    write(image, 34.4, 40, 20, U"L");
    for (int x = 20; x < 32; ++x) {
        image.row(32)[x] = 115;
        image.row(33)[x] = 160;
    }
    const auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(read_by_forms(InkStrip(image, lines[0]), font, {}).text, "\u2212L");
}

// Thin strokes are pale; what they tie together may be one letter, and what stands apart is none.
TEST(FormReader, ALetterInPiecesIsOne) {
    FontShapes shapes = strokes();
    shapes[U'O'] = {0.9, {box(0.1, 0, 0.8, 0.7), hole(0.2, 0.015, 0.7, 0.685)}};
    FormFont font(shapes);
    const auto read = [&](std::uint8_t thin) {
        Image image = make_image(200, 60, 1, 0, 255);
        write(image, 20, 40, 20, U"L");
        for (const int x : {37, 49})
            for (int y = 26; y < 40; ++y) image.row(y)[x] = image.row(y)[x + 1] = 0;
        for (int x = 39; x < 49; ++x) image.row(26)[x] = image.row(39)[x] = thin;
        const auto lines = find_lettering(image);
        EXPECT_EQ(lines.size(), 1u);
        const InkStrip strip(image, lines[0]);
        EXPECT_FALSE(strip.tied(0, 1));
        EXPECT_EQ(strip.tied(1, strip.units() - 1), thin < 255);
        return read_by_forms(strip, font, {}).text;
    };
    EXPECT_EQ(read(180), "LO");
    EXPECT_NE(read(255), "LO");
}

TEST(FormFont, ReadsFurtherLettersWhenOneIsAskedFor) {
    int times = 0;
    FontShapes few;
    few[U'L'] = strokes().at(U'L');
    FormFont font(few, [&] {
        ++times;
        return strokes();
    });
    EXPECT_FALSE(font.form(U'L').empty());
    EXPECT_EQ(times, 0);
    EXPECT_FALSE(font.form(U'O').empty());
    EXPECT_TRUE(font.form(U'x').empty());
    EXPECT_EQ(font.shapes().size(), strokes().size());
    EXPECT_EQ(times, 1);
}

TEST(FormReader, WhatIsNoLetterOfTheFontIsNotRead) {
    Image image = make_image(200, 60, 1, 0, 255);
    for (const int left : {20, 50})  // steps
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < y; ++x) image.row(20 + y)[left + x] = 0;
    const auto lines = find_lettering(image);
    ASSERT_EQ(lines.size(), 1u);
    FormFont font(strokes());
    EXPECT_EQ(read_by_forms(InkStrip(image, lines[0]), font, {}).text, "");
    double em = 0;
    EXPECT_LT(likeness_to(InkStrip(image, lines[0]), font, "LL", em), 0.7);
}

}  // namespace
}  // namespace tactics::letter_form_test
