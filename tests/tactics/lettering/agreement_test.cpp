// SPDX-License-Identifier: Apache-2.0
// What two readers of a line say together.
#include "tactics/lettering/agreement.h"

#include <gtest/gtest.h>

namespace tactics::agreement_test {
namespace {

// A line of a known font and size, a letter of each code; 0 is like none.
FormWords line_of(std::u32string_view codes, std::string text, double likeness = 0.95) {
    FormWords words;
    words.font = 0;
    words.settled = words.sized = true;
    words.text = std::move(text);
    for (const char32_t code : codes) {
        FormLetter letter;
        letter.code = code;
        letter.likeness = code == 0 ? 0 : likeness;
        words.reading.letters.push_back(letter);
    }
    words.reading.mean = words.reading.least = likeness;
    words.reading.em = 20;
    return words;
}

TEST(Agreement, FontsDecideWhereTheyAreClear) {
    const Belief belief = believe(line_of(U"q1", "q1"), {"ql", 96, true, true});
    EXPECT_TRUE(belief.sure);
    EXPECT_EQ(belief.text, "q1");
    EXPECT_FALSE(believe(line_of(U"q1", "q1", 0.7), {"ql", 96, true, true}).sure);
}

TEST(Agreement, FiguresThatEndWithADashGoOn) {
    EXPECT_FALSE(believe(line_of(U"1e\u2212", "1e\u2212"), {"1e-", 96, true, true}).sure);
    EXPECT_TRUE(believe(line_of(U"1e\u221214", "1e\u221214"), {"1e-14", 96, true, true}).sure);
    EXPECT_TRUE(believe(line_of(U"Cl\u2212", "Cl\u2212"), {"Cl-", 96, true, true}).sure);
}

// Ten points at 72 dpi; both readers say the same.
bool is_sure_in_small(std::u32string_view codes, const std::string& text, const std::string& other, double likeness = 0.95) {
    FormWords words = line_of(codes, text, likeness);
    words.reading.em = 10;
    words.agreed = true;
    return believe(words, {other, 96, true, true}).sure;
}

TEST(Agreement, InSmallPrintTwoLettersThatTouchAreNotTakenForOne) {
    EXPECT_TRUE(is_sure_in_small(U"Age", "Age", "Age"));
    EXPECT_TRUE(is_sure_in_small(U"dose", "dose", "dose"));
    EXPECT_FALSE(is_sure_in_small(U"dock", "dock", "dock", 0.82)) << "clock";
    EXPECT_FALSE(is_sure_in_small(U"Com", "Com", "Com")) << "Corn";
}

TEST(Agreement, LettersThatTouchAreNotTakenForOneAgainstTheOtherReader) {
    const auto is_sure = [](double likeness) {
        FormWords words = line_of(U"germanmm", "germanmm");
        words.reading.letters[6].likeness = words.reading.least = likeness;
        return believe(words, {"germanium", 70, true, false}).sure;
    };
    EXPECT_FALSE(is_sure(0.78));
    EXPECT_TRUE(is_sure(0.9));
}

TEST(Agreement, ALetterThatTheOtherReaderTakesForTwoIsAllTheMoreLikeItself) {
    const auto is_sure = [](double likeness, const char* other, bool sure) {
        FormWords words = line_of(U"Fumace", "Fumace", 0.97);
        words.reading.letters[2].likeness = words.reading.least = likeness;
        words.reading.mean = 0.95;
        return believe(words, {other, 96, true, sure}).sure;
    };
    EXPECT_FALSE(is_sure(0.91, "Furnace", true));
    EXPECT_TRUE(is_sure(0.97, "Furnace", true));
    EXPECT_TRUE(is_sure(0.91, "Furnace", false)) << "the other reader is not sure";
    EXPECT_TRUE(is_sure(0.91, "Furmace", true)) << "other letters, too";
}

TEST(Agreement, InSmallPrintSignsInFiguresAreNotGuessed) {
    EXPECT_TRUE(is_sure_in_small(U"0.25", "0.25", "0.25"));
    EXPECT_TRUE(is_sure_in_small(U"0.125", "0.125", "0.125"));
    EXPECT_TRUE(is_sure_in_small(U"1,000", "1,000", "1,000"));
    EXPECT_FALSE(is_sure_in_small(U"1.000", "1.000", "1,000"));
    EXPECT_FALSE(is_sure_in_small(U"1.000", "1.000", "1.000")) << "the tail of a comma is pale";
    EXPECT_FALSE(is_sure_in_small(U"4-", "4 -", "4 -")) << "the tick of a scale";
    EXPECT_FALSE(is_sure_in_small(U"00O", "00O", "00O"));
    EXPECT_FALSE(is_sure_in_small(U"02", "02", "02")) << "0.2";
    EXPECT_FALSE(is_sure_in_small(U"10*", "10*", "10*")) << "a raised 4";
    EXPECT_TRUE(is_sure_in_small(U"20", "20", "20"));
    EXPECT_FALSE(is_sure_in_small(U"20", "20", "20", 0.76)) << "no word bears out a figure";
}

TEST(Agreement, PrintOfNoKnownFontTakesASureReader) {
    const auto sure = [](double likeness, double sureness, std::u32string_view codes = U"Hand",
                         const std::string& text = "Hand") {
        FormWords words = line_of(codes, text, likeness);
        words.sized = false;
        words.agreed = words.strange = true;
        const Belief belief = believe(words, {text, sureness, true, sureness >= 60});
        EXPECT_TRUE(belief.tell);
        return belief.sure;
    };
    EXPECT_TRUE(sure(0.7, 91));
    EXPECT_FALSE(sure(0.7, 89));
    EXPECT_TRUE(sure(0.6, 96));
    EXPECT_FALSE(sure(0.6, 91)) << "less like the letters of any font";
    EXPECT_TRUE(sure(0.85, 40, U"20", "20")) << "figures need none that knows words";
    EXPECT_FALSE(sure(0.85, 40));
    EXPECT_FALSE(sure(0.85, 96, U"IO", "IO")) << "10";
    EXPECT_FALSE(sure(0.85, 96, U"cox", "cox")) << "COX";
}

TEST(Agreement, ABracketWithoutAPartnerWaitsForIt) {
    FormWords words = line_of(U"0.98)", "0.98)");
    words.agreed = true;
    const ReadWords other{"0.98)", 96, true, true};
    for (const double em : {20.0, 14.0}) {  // it may touch what is drawn
        words.reading.em = em;
        EXPECT_TRUE(!believe(words, other).sure && believe(words, other).open);
    }
    words.reading.least = words.reading.mean = 0.5;
    EXPECT_FALSE(believe(words, other).open) << "nor is it read";
    words = line_of(U"(b)", "(b)");
    words.reading.em = 14;
    words.agreed = true;
    EXPECT_FALSE(believe(words, {"(b)", 96, true, true}).open);
}

TEST(Agreement, AnMBeyondDoubtNeedsNoSurerReader) {
    const auto sure = [](double em, double likeness, double sureness, bool sized = true) {
        FormWords words = line_of(U"Modes", "Modes", likeness);
        words.reading.em = em;
        words.agreed = true;
        words.sized = sized;
        return believe(words, {"Modes", sureness, true, sureness >= 60}).sure;
    };
    EXPECT_TRUE(sure(14, 0.95, 80));
    EXPECT_FALSE(sure(14, 0.88, 80));
    EXPECT_TRUE(sure(14, 0.88, 90));
    EXPECT_TRUE(sure(12, 0.95, 80)) << "of 12 pixels, as charts on web pages have it";
    EXPECT_FALSE(sure(12, 0.95, 80, false)) << "the size of no other words";
}

TEST(Agreement, ALineInLettersOfItsFontNeedsNoOtherReader) {
    const auto sure = [](double em, double likeness, bool sized) {
        FormWords words = line_of(U"Leave", "Leave", likeness);
        words.reading.em = em;
        words.sized = sized;
        return believe(words, {"Leave.^?", 30, false, false}).sure;
    };
    EXPECT_TRUE(sure(15, 0.96, true));
    EXPECT_FALSE(sure(15, 0.92, true));
    EXPECT_FALSE(sure(12, 0.96, true)) << "too few pixels";
    EXPECT_FALSE(sure(15, 0.96, false)) << "of a size of its own";
}

TEST(Agreement, DegreesOfFewPixelsAreTheirOwnWitness) {
    FormWords words = line_of(U"\u00b0C", "\u00b0C", 0.9);
    words.reading.em = 12;
    EXPECT_TRUE(believe(words, {"", 0, false, false}).sure);
    words.sized = false;
    EXPECT_FALSE(believe(words, {"", 0, false, false}).sure);
    FormWords other = line_of(U"BC", "BC", 0.9);
    other.reading.em = 12;
    EXPECT_FALSE(believe(other, {"", 0, false, false}).sure);
}

TEST(Agreement, InPrintOfFewPixelsBothReadersMustSayIt) {
    FormWords words = line_of(U"88", "88");
    words.reading.em = 10;
    EXPECT_FALSE(believe(words, {"SB", 96, false, false}).sure) << "S8";
    words.agreed = true;
    EXPECT_TRUE(believe(words, {"88", 96, true, true}).sure);
    words = line_of(U"88", "88");
    EXPECT_TRUE(believe(words, {"SB", 96, false, false}).sure) << "of 20 pixels";
}

TEST(Agreement, NumbersOfFewPixelsMayBeBorneOutByAnAxis) {
    const auto at = [](double em, const std::u32string& codes, const ReadWords& other) {
        FormWords words = line_of(codes, std::string(codes.begin(), codes.end()));
        words.reading.em = em;
        words.agreed = words.text == other.text;
        return believe(words, other);
    };
    const Belief unasked = at(12, U"20", {}), climbing = at(20, U"20", {}), denied = at(12, U"20", {"26", 96, true, true});
    EXPECT_TRUE(!unasked.sure && unasked.nearly && unasked.tell);
    EXPECT_TRUE(climbing.sure);
    EXPECT_FALSE(denied.sure || denied.nearly);
    for (const char32_t figure : std::u32string_view(U"3689")) {
        const std::u32string codes{figure, U'0'};
        const std::string text(codes.begin(), codes.end());
        const Belief speck = at(8, codes, {text, 96, true, true}), small = at(10, codes, {text, 96, true, true}),
                     alone = at(8, {figure}, {});
        EXPECT_TRUE(!speck.sure && speck.nearly && speck.tell) << text << ": 960 was 980";
        EXPECT_TRUE(small.sure) << text;
        EXPECT_TRUE(!alone.sure && alone.nearly && alone.tell) << text;
    }
    EXPECT_TRUE(at(8, U"120", {"120", 96, true, true}).sure);
}

TEST(Agreement, BothReadersTakeSmallPrintInCapitalsForLowerCase) {
    FormWords words = line_of(U"cl2", "cl2");
    words.reading.em = 12;
    words.agreed = true;
    EXPECT_TRUE(believe(words, {"cl2", 96, true, true}).sure);
    words.reading.either = true;
    words.sized = false;
    EXPECT_FALSE(believe(words, {"cl2", 96, true, true}).sure) << "Cl2";
}

TEST(Agreement, InSmallPrintThinStrokesAreNotCountedAndBracketsHavePairs) {
    EXPECT_FALSE(is_sure_in_small(U"il", "il", "il")) << "ill";
    EXPECT_TRUE(is_sure_in_small(U"ail", "ail", "ail"));
    EXPECT_FALSE(is_sure_in_small(U"git)", "git)", "git)")) << "g(t)";
    EXPECT_TRUE(is_sure_in_small(U"f(x)", "f(x)", "f(x)"));
    EXPECT_TRUE(is_sure_in_small(U"a)", "a)", "a)"));
    EXPECT_TRUE(is_sure_in_small(U"[0,1]", "[0,1]", "[0,1]"));
    EXPECT_FALSE(is_sure_in_small(U"f(x", "f(x", "f(x"));
}

TEST(Agreement, WhatLooksLikeOtherLettersIsNotSure) {
    FormWords either = line_of(U"cos", "cos");
    either.reading.either = true;
    EXPECT_FALSE(believe(either, {"COS", 96, true, true}).sure);
    FormWords open = line_of(U"Il", "Il");
    open.settled = false;
    EXPECT_FALSE(believe(open, {"ll", 96, true, true}).sure);
}

// Both readers say so, and neither sees how large the letters should be.
TEST(Agreement, OnlyPrintOfItsSizeTellsCapitalsFromSmallLetters) {
    const auto is_sure = [](std::u32string_view codes, const std::string& text, bool sized) {
        FormWords words = line_of(codes, text);
        words.agreed = true;
        words.sized = sized;
        return believe(words, {text, 96, true, true}).sure;
    };
    EXPECT_FALSE(is_sure(U"COSX", "COS X", false));
    EXPECT_FALSE(is_sure(U"vox", "vox", false));
    EXPECT_TRUE(is_sure(U"cosx", "cos x", true));
    EXPECT_TRUE(is_sure(U"cost", "cost", false)) << "a t is no T";
}

TEST(Agreement, APieceThatIsLikeNoLetterMayOnlyBeALetterThatTheOtherReads) {
    const char32_t none = 0;
    EXPECT_TRUE(believe(line_of(std::u32string{U'B', none, U'r', U'c', U'h'}, ""), {"Birch", 95, true, true}).sure);
    EXPECT_FALSE(believe(line_of(std::u32string{U'B', none, U'r', U'c', U'h'}, ""), {"Birch", 50, true, false}).sure);
    EXPECT_FALSE(believe(line_of(std::u32string{U'7', none, U'5'}, ""), {"75", 95, true, true}).sure);   // a point, lost
    EXPECT_FALSE(believe(line_of(std::u32string{U'1', U'7', none}, ""), {"173", 95, true, true}).sure);  // or any figure
    EXPECT_FALSE(believe(line_of(std::u32string{none, none, U'r', none}, ""), {"Birc", 95, true, true}).sure);
    FormWords square = line_of(std::u32string{none, U'/', U's', U'2'}, "");
    square.reading.letters.back().place = FormLetter::Place::raised;
    EXPECT_FALSE(believe(square, {"m/s2", 95, true, true}).sure);
}

// "gt" touch and were read as "et"; an alpha among figures was read as "a".
TEST(Agreement, APieceThatIsLikeNoLetterIsNotWhatItCannotBe) {
    const auto is_sure = [](std::u32string_view codes, const char* other, double likeness, double bottom) {
        FormWords words = line_of(codes, "", likeness);
        words.reading.foot = 20;
        for (FormLetter& letter : words.reading.letters) letter.box = {0, 5, 10, letter.code == 0 ? bottom : 20};
        return believe(words, {other, 96, true, true}).sure;
    };
    const std::u32string_view gap(U"Len\0hof", 7), alpha(U"\0=30", 4);
    EXPECT_TRUE(is_sure(gap, "Leneth of", 0.87, 20.5));
    EXPECT_FALSE(is_sure(gap, "Leneth of", 0.87, 25));
    EXPECT_TRUE(is_sure(gap, "Lenyth of", 0.87, 25));
    EXPECT_FALSE(is_sure(alpha, "a=30", 0.95, 20));
}

TEST(Agreement, ALetterAloneIsSureInTheSizeOfWordsAndIsNoCircle) {
    EXPECT_TRUE(believe(line_of(U"A", "A"), {}).sure);
    EXPECT_FALSE(believe(line_of(U"o", "o"), {}).sure);
    EXPECT_FALSE(believe(line_of(U"|", "|"), {}).sure);
    FormWords unsized = line_of(U"A", "A");
    unsized.sized = false;
    EXPECT_FALSE(believe(unsized, {}).sure);
    EXPECT_FALSE(believe(unsized, {}).tell);
}

// A number has no letters that look like figures; a formula may have them behind another letter.
TEST(Agreement, AnOIsNoZero) {
    for (const char* wrong : {"5.O", "1O.O", "2l", "\u22121O", "1,0OO", "10 Q", "R = 10 Q", "l00"})
        EXPECT_TRUE(has_letter_for_figure(wrong)) << wrong;
    for (const char* right :
         {"5.0", "O2", "H2O", "10 Ohm", "10 cm", "Q 10", "Il", "", "\u2212", "2nd", "1 of 2", "3D", "l1", "lot"})
        EXPECT_FALSE(has_letter_for_figure(right)) << right;
}

TEST(Agreement, AFormulaDoesNotBeginWithASignBetweenTwo) {
    for (const char* wrong : {"+ 1", "= 5 cm", "> 0 ?", "* 2"}) EXPECT_TRUE(begins_in_formula(wrong)) << wrong;
    for (const char* right : {"+1", "x + 1", "\u2212 2", "+", "+ ", "", "<b>", "a = 5"})
        EXPECT_FALSE(begins_in_formula(right)) << right;
}

TEST(Agreement, ALetterOfAFormulaMayBeGreek) {
    for (const char* doubtful : {"a = 30\u00b0", "R = 10", "2 x = 4"}) EXPECT_TRUE(names_letter_in_formula(doubtful)) << doubtful;
    for (const char* plain : {"mean = 30", "vitamin a", "5 = 5", "=", ""}) EXPECT_FALSE(names_letter_in_formula(plain)) << plain;
}

TEST(Agreement, AWordOfSmallLettersEndsWithNoCapitalI) {
    for (const char* wrong : {"MilI", "MilI Road", "OwI nest"}) EXPECT_TRUE(ends_word_with_capital_i(wrong)) << wrong;
    for (const char* right : {"Mill", "World War I", "II", "McIntyre", "I", ""})
        EXPECT_FALSE(ends_word_with_capital_i(right)) << right;
}

}  // namespace
}  // namespace tactics::agreement_test
