// SPDX-License-Identifier: Apache-2.0
// Print in a font that is not installed.
#include "tactics/lettering/strange_print.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tactics/lettering/alignment.h"
#include "tactics/lettering/form_words.h"
#include "tactics/lettering/meant_letters.h"
#include "tactics/lettering/pale_ink.h"
#include "tactics/lettering/read_line.h"
#include "tactics/text/utf8.h"
#include "tests/tactics/lettering/stroke_font.h"

namespace tactics::strange_print_test {
namespace {

using namespace stroke_font;

// Written in a thinner font, whose small letters are lower, than the one that is known.
std::optional<FormReading> borne_out(std::u32string_view text, const std::string& told, double low = 0.46) {
    const Image image = written(strokes(0.08, low), text, 30);
    FormFont known(strokes(0.12, low + 0.04));
    return bear_out(InkStrip(image, line_in(image)), told, {&known});
}

TEST(StrangePrint, IsBorneOutLetterByLetter) {
    const auto reading = borne_out(U"LoTnHi", "LoTnHi");
    ASSERT_TRUE(reading.has_value());
    EXPECT_EQ(reading->text, "LoTnHi");
    EXPECT_NEAR(reading->em, 30, 2);
    EXPECT_FALSE(borne_out(U"LoTnHi", "LoLnHi").has_value()) << "a T is no L";
    EXPECT_FALSE(borne_out(U"LnTnHi", "LoTnHi").has_value()) << "it looks more like an n";
    EXPECT_FALSE(borne_out(U"LoTnHi", "LOTnHi").has_value()) << "it is too low for a capital";
    EXPECT_FALSE(borne_out(U"LOTnHi", "LoTnHi").has_value()) << "it is too high for a small one";
    EXPECT_FALSE(borne_out(U"LoTnHi", "LOTnHi", 0.58).has_value()) << "though small letters are high";
    EXPECT_FALSE(borne_out(U"LoTnHi", "LoTnH").has_value()) << "a letter is left";
    EXPECT_FALSE(borne_out(U"LoTnHi", "LoTnHiL").has_value()) << "a letter has no ink";
    EXPECT_FALSE(borne_out(U"LoTnHi", "").has_value());
}

TEST(StrangePrint, HasItsSpacesWhereTheGapsAre) {
    EXPECT_EQ(borne_out(U"Lon Hin", "Lon Hin")->text, "Lon Hin");
    EXPECT_EQ(borne_out(U"Lon Hin", "LonHin")->text, "") << "a space is not told";
    EXPECT_EQ(borne_out(U"LonHin", "Lon Hin")->text, "") << "there is no gap";
    const auto reading = borne_out(U"Lon Hin", "Lon Hin");
    EXPECT_EQ(with_its_gaps(*reading, "LonHin", "Lon Hin"), "Lon Hin");
    EXPECT_EQ(with_its_gaps(*borne_out(U"LonHin", "LonHin"), "LonHin", "Lon Hin"), std::nullopt) << "gaps as wide as others";
    EXPECT_EQ(with_its_gaps(*reading, "LonH in", "Lon Hin"), "Lon Hin");
    EXPECT_EQ(with_its_gaps(*reading, "Lon Hin", "Lo nHin"), "Lon Hin");
}

TEST(Alignment, FindsLettersThatTouchAndLettersThatCameApart) {
    FormFont font(strokes(0.12, 0.5));
    const Image close = written(strokes(0.1, 0.5), U"LonHi", 30, 0.12);
    const InkStrip joined(close, line_in(close));
    ASSERT_LT(joined.units(), 5u);
    const auto touching = align(joined, font, U"LonHi");
    ASSERT_TRUE(touching.has_value());
    ASSERT_EQ(touching->letters.size(), 5u);
    EXPECT_TRUE(
        std::any_of(touching->letters.begin(), touching->letters.end(), [](const AlignedLetter& one) { return one.shared; }));
    for (std::size_t i = 1; i < 5; ++i) EXPECT_GT(touching->letters[i].box.left, touching->letters[i - 1].box.left) << i;

    FontShapes broken = strokes(0.1, 0.5);
    broken.at(U'n').rings.pop_back();  // two stems
    const Image apart = written(broken, U"LonHi", 30);
    const InkStrip pieces(apart, line_in(apart));
    ASSERT_EQ(pieces.units(), 6u);
    const auto found = align(pieces, font, U"LonHi");
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->letters[2].last, found->letters[2].first + 1);
    EXPECT_EQ(found->letters[3].first, found->letters[2].last + 1);
}

TEST(StrangePrint, CapitalsAndSmallLettersAreEachOfOneHeight) {
    const auto reading = [](std::initializer_list<std::pair<char32_t, double>> letters) {
        FormReading made;
        for (const auto& [code, height] : letters) {
            FormLetter letter;
            letter.code = code;
            letter.box = {0, 0, 10, height};
            made.letters.push_back(letter);
        }
        return made;
    };
    EXPECT_TRUE(is_of_mixed_case(reading({{U'R', 20}, {U'o', 15}, {U'W', 15}}))) << "Row";
    EXPECT_FALSE(is_of_mixed_case(reading({{U'R', 20}, {U'o', 15}, {U'w', 15}})));
    EXPECT_TRUE(is_of_mixed_case(reading({{U's', 20}, {U'a', 15}, {U'w', 15}}))) << "Saw";
    EXPECT_FALSE(is_of_mixed_case(reading({{U'B', 10}, {U'W', 9}}))) << "a pixel is no difference";
    FormReading touching = reading({{U'r', 20}, {U'l', 20}, {U'a', 15}});
    EXPECT_TRUE(is_of_mixed_case(touching));
    touching.letters[0].touches = true;
    EXPECT_FALSE(is_of_mixed_case(touching)) << "its height is that of both";
}

TEST(StrangePrint, RingsAndStrokesBesideFiguresMayBeFigures) {
    EXPECT_TRUE(may_be_figures("7O", false));
    EXPECT_TRUE(may_be_figures("up to 1l", false));
    EXPECT_FALSE(may_be_figures("O2", true));
    EXPECT_FALSE(may_be_figures("70", true));
    EXPECT_FALSE(may_be_figures("q0", true));
    EXPECT_TRUE(may_be_figures("IO", true));
    EXPECT_FALSE(may_be_figures("II", false));
    EXPECT_TRUE(may_be_figures("from ql", true)) << "q1";
    EXPECT_FALSE(may_be_figures("ql", false));
    EXPECT_FALSE(may_be_figures("so", true));
    EXPECT_FALSE(may_be_figures("", true));
}

// A line of a font in which I and l look the same; 15 pixels are small print.
FormWords settled_line(std::u32string_view codes, const std::string& told, double em = 15) {
    FormWords words;
    for (const char32_t code : codes) {
        FormLetter letter;
        letter.code = code;
        if (code == U'l') letter.alike = {U'I'};
        if (code == U'I') letter.alike = {U'l'};
        words.reading.letters.push_back(letter);
        append_letter(words.reading.text, code);
    }
    words.reading.em = em;
    settle(words, {told, true});
    return words;
}

TEST(StrangePrint, NoWordBeginsWithAnLAndAnotherConsonant) {
    const auto settled = [](std::u32string_view codes, const std::string& told) { return settled_line(codes, told, 20).settled; };
    EXPECT_FALSE(settled(U"lcm", "lcm"));
    EXPECT_FALSE(settled(U"lhs", "lhs"));
    EXPECT_TRUE(settled(U"lane", "lane"));
    EXPECT_TRUE(settled(U"lyre", "lyre"));
    EXPECT_TRUE(settled(U"llama", "llama"));
    EXPECT_TRUE(settled(U"lb", "lb"));
    EXPECT_FALSE(settled(U"(lb)", "(Ib)"));
    EXPECT_TRUE(settled(U"lbs", "lbs"));
    EXPECT_FALSE(settled(U"(lbs)", "(Ibs)"));
    EXPECT_FALSE(settled(U"lt", "lt")) << "It";
    EXPECT_TRUE(settled(U"ln", "In"));
    EXPECT_TRUE(settled(U"ln", "ln"));
    EXPECT_FALSE(settled(U"ln(2)", "In(2)"));
}

TEST(StrangePrint, WhatBeginsWithLAConsonantAndAVowelBeginsWithACapitalI) {
    for (const auto& [codes, told] : {std::pair{U"lron", "lron"}, {U"lda", "lda"}, {U"lce", "lce"}, {U"lvy", "lvy"}}) {
        const FormWords words = settled_line(codes, told, 20);
        EXPECT_TRUE(words.settled) << told;
        EXPECT_EQ(words.reading.letters.front().code, U'I') << told;
    }
}

TEST(StrangePrint, ACapitalMayBeginAJoinedWord) {
    EXPECT_FALSE(settled_line(U"sizelnFeet", "sizelnFeet").settled) << "sizeInFeet";
    EXPECT_TRUE(settled_line(U"camelCase", "camelCase").settled);
    EXPECT_TRUE(settled_line(U"isMammal", "isMammal").settled);
    EXPECT_TRUE(settled_line(U"scale", "scale").settled);
}

TEST(StrangePrint, AnotherReaderTellsTheLettersBeforeItErrs) {
    const FormWords words = settled_line(U"Isitraining?", "Is it raining.^?");
    EXPECT_TRUE(words.settled);
    EXPECT_EQ(words.reading.letters[0].code, U'I');
    EXPECT_FALSE(settled_line(U"Isitraining?", "^ it raining?").settled);
    EXPECT_FALSE(settled_line(U"Inx", "Inx?").settled) << "or ln";
}

TEST(StrangePrint, ALoneFigureIsAsHighAsOthers) {
    const FontShapes strange = strokes(0.1, 0.46), known = strokes(0.12, 0.5, 0.85);
    const Image numbers = written(strange, U"1010", 30), seven = written(strange, U"7", 30), small = written(strange, U"7", 22);
    const std::vector<InkStrip> strips{InkStrip(numbers, line_in(numbers)), InkStrip(seven, line_in(seven)),
                                       InkStrip(small, line_in(small))};
    const PrintFonts fonts = [&](const std::vector<char32_t>&, const std::function<bool(PrintFont)>& goes_on) {
        goes_on(PrintFont{known});
    };
    const std::vector<FormWords> words = read_in_fonts(strips, {{"1010", true}, {}, {}}, fonts);
    ASSERT_EQ(words.size(), 3u);
    EXPECT_EQ(words[1].text, "7");
    EXPECT_TRUE(words[1].sized) << "as high as the other figures, though not of their em in the known font";
    EXPECT_FALSE(words[2].sized);
}

TEST(StrangePrint, ALoneFigureOfNoFontOfTheWordsIsLeftToItsAxis) {
    const FontShapes strange = strokes(0.1, 0.46);
    FontShapes without = strokes(0.12, 0.5);
    without.erase(U'7');
    const Image numbers = written(strange, U"1010", 30), seven = written(strange, U"7", 30);
    const std::vector<InkStrip> strips{InkStrip(numbers, line_in(numbers)), InkStrip(seven, line_in(seven))};
    const PrintFonts fonts = [&](const std::vector<char32_t>&, const std::function<bool(PrintFont)>& goes_on) {
        goes_on(PrintFont{without});
        goes_on(PrintFont{{{U'7', strange.at(U'7')}}});
    };
    const std::vector<FormWords> words = read_in_fonts(strips, {{"1010", true}, {}}, fonts);
    ASSERT_EQ(words.size(), 2u);
    EXPECT_EQ(words[1].text, "");
    EXPECT_EQ(words[1].reading.text, "7");
}

Image broken_ring() {
    Image image = make_image(60, 40, 1, 0, 255);
    const auto fill = [&](int left, int top, int right, int bottom, std::uint8_t value) {
        for (int y = top; y < bottom; ++y) std::fill(image.row(y) + left, image.row(y) + right, value);
    };
    fill(20, 10, 22, 26, 0);  // a 0 whose arcs are thin
    fill(30, 10, 32, 26, 0);
    fill(22, 10, 30, 11, 170);
    fill(22, 25, 30, 26, 170);
    return image;
}

TEST(PaleInk, JoinsWhatThinStrokesLeaveApart) {
    Image image = broken_ring();
    LetteringLine line = line_in(image);
    ASSERT_EQ(line.letters.size(), 2u);
    EXPECT_EQ(joined_by_pale_ink(image, line).letters.size(), 1u);
    std::fill(image.row(10), image.row(10) + 20, std::uint8_t{170});  // a pale line leads out of it
    EXPECT_EQ(joined_by_pale_ink(image, line).letters.size(), 2u);
}

TEST(PaleInk, HalvesOfARingAreOneLetter) {
    const Image image = broken_ring();
    const auto letters_of = [&](const std::string& text, bool alike) {
        std::vector<ReadLine> lines(1);
        lines[0].line = line_in(image);
        lines[0].words.text = text;
        lines[0].alike = alike;
        EXPECT_TRUE(hold_against_fonts(image, lines, {},
                                       [](const auto&, const auto& goes_on) { goes_on(PrintFont{strokes(0.1, 0.5)}); }));
        return lines[0].line.letters.size();
    };
    EXPECT_EQ(letters_of("0)", false), 1u);
    EXPECT_EQ(letters_of("()", true), 2u) << "read twice alike";
}

// Two rings, the right sides of which come apart.
TEST(PaleInk, ALineInPiecesIsMadeWhole) {
    Image image = make_image(80, 40, 1, 0, 255);
    const auto fill = [&](int left, int top, int right, int bottom, std::uint8_t value) {
        for (int y = top; y < bottom; ++y) std::fill(image.row(y) + left, image.row(y) + right, value);
    };
    for (const int left : {20, 40}) {
        fill(left, 10, left + 2, 26, 0);
        fill(left + 10, 10, left + 12, 15, 0);
        fill(left + 10, 20, left + 12, 26, 0);
        fill(left + 2, 10, left + 10, 11, 170);
        fill(left + 2, 25, left + 10, 26, 170);
        fill(left + 10, 15, left + 11, 20, 170);
    }
    LetteringLine line;
    line.level = 128;
    line.box = {20, 10, 52, 26};
    line.letter_height = 14;
    for (InkPiece& piece : pieces_of(image, 128, false, 60))
        (piece.box.height() > 10 ? line.letters : line.marks).push_back(std::move(piece));
    ASSERT_EQ(line.marks.size(), 4u);
    const LetteringLine whole = whole_if_broken(image, line);
    EXPECT_EQ(whole.letters.size(), 2u);
    EXPECT_TRUE(whole.marks.empty());
    EXPECT_EQ(whole.letter_height, 16);
    fill(32, 12, 40, 13, 170);  // from ring to ring, and to what follows
    fill(52, 12, 58, 13, 170);
    EXPECT_EQ(whole_if_broken(image, line).letters.size(), 2u);
    EXPECT_EQ(whole_if_broken(image, line).marks.size(), 4u) << "a whole word is no letter";
    fill(32, 12, 40, 13, 255);
    fill(52, 12, 58, 13, 255);
    line.marks.resize(2);  // points of two letters
    EXPECT_EQ(whole_if_broken(image, line).marks.size(), 2u);
}

TEST(StrangePrint, AnotherReaderKnowsNoSigns) {
    EXPECT_TRUE(same_but_for_signs("P(cos θ, sinθ)", "P(cos 6, sin @)"));
    EXPECT_FALSE(same_but_for_signs("P(cos θ, sinθ)", "P(cas 6, sin @)"));
    EXPECT_FALSE(same_but_for_signs("cosθ", "cos")) << "of another length";
    EXPECT_FALSE(same_but_for_signs("2πr", "2ar")) << "too few that both say";
    EXPECT_FALSE(same_but_for_signs("1θ00", "1000")) << "a zero with a point in it";
}

}  // namespace
}  // namespace tactics::strange_print_test
