// SPDX-License-Identifier: Apache-2.0
// Letters that touch a line which is drawn are freed of it, and read as far as they are seen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tactics/lettering/read_line.h"
#include "tactics/lettering/veiled_letter.h"
#include "tests/tactics/lettering/stroke_font.h"

namespace tactics::freed_letters_test {
namespace {

using stroke_font::box;
using stroke_font::ring;
using stroke_font::strokes;
using stroke_font::written;

// Letters stand from (20, 20) to the right, on y = 40.
void draw_line(Image& image, double from_x, double from_y, double to_x, double to_y, double thick) {
    const double length = std::hypot(to_x - from_x, to_y - from_y), dx = (to_x - from_x) / length, dy = (to_y - from_y) / length;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double along = (x - from_x) * dx + (y - from_y) * dy, across = (x - from_x) * dy - (y - from_y) * dx;
            if (along < 0 || along > length || std::abs(across) > thick / 2 + 1) continue;
            image.row(y)[x] = std::min<std::uint8_t>(image.row(y)[x], std::abs(across) <= thick / 2 ? 0 : 180);
        }
}

std::vector<std::size_t> letters_of(const std::vector<FreedLine>& lines) {
    std::vector<std::size_t> letters;
    for (const FreedLine& one : lines) letters.push_back(one.line.letters.size());
    return letters;
}

TEST(FreedLetters, OfALineAcrossThem) {
    Image image = written(strokes(0.1, 0.5), U"HnTo", 30);
    EXPECT_TRUE(freed_lines(image, find_lettering(image)).empty()) << "nothing touches them";
    draw_line(image, 22, 0, 36, 59, 2);  // through the H
    const std::vector<LetteringLine> lines = find_lettering(image);
    const std::vector<FreedLine> freed = freed_lines(image, lines);
    ASSERT_FALSE(freed.empty());
    EXPECT_EQ(letters_of(freed)[0], 5u) << "the H in two parts";
    EXPECT_FALSE(freed[0].line.veil.empty());
    const bool far =
        std::any_of(freed[0].line.veil.begin(), freed[0].line.veil.end(), [](const InkRun& run) { return run.right > 40; });
    EXPECT_FALSE(far) << "letters are no veil";
    FormFont font(strokes(0.1, 0.5));
    EXPECT_EQ(read_by_forms(InkStrip(image, freed[0].line), font, {30}).text, "HnTo");
}

TEST(FreedLetters, LinesThatArePartedBecomeOne) {
    Image image = written(strokes(0.1, 0.5), U"noHno", 30);
    draw_line(image, 58, 0, 54, 59, 2);  // through the H
    const std::vector<LetteringLine> lines = find_lettering(image);
    const std::vector<FreedLine> freed = freed_lines(image, lines);
    ASSERT_GE(lines.size(), 2u);
    ASSERT_FALSE(freed.empty());
    EXPECT_GE(letters_of(freed)[0], 5u);
    for (const LetteringLine& one : lines) {
        if (one.letters.size() < 2) continue;
        EXPECT_EQ(around(freed[0].line.box, one.box), freed[0].line.box);
    }
}

TEST(FreedLetters, ATickIsNone) {
    Image image = written(strokes(0.1, 0.5), U"10", 30);
    draw_line(image, 10, 0, 10, 59, 2);
    draw_line(image, 10, 30, 18, 30, 2);
    for (const FreedLine& one : freed_lines(image, find_lettering(image)))
        EXPECT_EQ(one.line.letters.size() + one.line.marks.size(), 2u);
}

// "c" and "d" of straight strokes, and an "n".
FontShapes cdn() {
    FontShapes font = strokes(0.1, 0.5);
    const FontShape o = ring(0.4, 0.5, 0.1);
    font[U'c'] = {0.5, {o.rings[0], o.rings[1], o.rings[2]}};
    font[U'd'] = {0.5, {o.rings[0], o.rings[1], o.rings[2], box(0.35, 0, 0.45, 0.7)}};
    font.erase(U'o');
    return font;
}

// Of the last letter, of which that part is veiled.
char32_t last_letter(const std::u32string& text, const PixelBox& veil) {
    FormFont font(cdn());
    const Image image = written(cdn(), text, 30);
    LetteringLine line = find_lettering(image).at(0);
    for (int y = veil.top; y < veil.bottom; ++y) line.veil.push_back({y, veil.left, veil.right});
    const InkStrip strip(image, line);
    const InkBox box = strip.measure(0, 0);
    const double foot = box.bottom;
    EXPECT_TRUE(strip.has_veil());
    const double right = strip.measure(strip.units() - 1, strip.units() - 1).right + line.box.left - 2;  // of the picture
    EXPECT_LE(right, veil.left > 60 ? veil.left - 1 : 80) << "without what the veil covers";
    return veiled_letter(strip, strip.units() - 1, strip.units() - 1, font, 30, foot).code;
}

TEST(VeiledLetter, IsReadAsFarAsItIsSeen) {
    const PixelBox above{50, 0, 70, 3}, stem{65, 0, 69, 60}, all{40, 0, 80, 60};
    EXPECT_EQ(last_letter(U"Hnc", above), U'c');
    EXPECT_EQ(last_letter(U"Hnd", above), U'd');
    EXPECT_EQ(last_letter(U"Hnc", stem), U'\0') << "or a d";
    EXPECT_EQ(last_letter(U"Hnn", {58, 32, 61, 60}), U'n') << "a stem is hidden in part";
    EXPECT_EQ(last_letter(U"HTn", all), U'\0');
}

}  // namespace
}  // namespace tactics::freed_letters_test
