// SPDX-License-Identifier: Apache-2.0
// Words of a PDF in the place of the letters that pdftocairo drew. What both programs write was taken from poppler 22.12.
#include "tactics/readers/svg/pdf_text.h"

#include <gtest/gtest.h>

#include "tactics/error.h"
#include "tactics/readers/svg/cairo_glyphs.h"
#include "tactics/readers/svg/svg.h"

namespace tactics::pdf_text_test {
namespace {

struct Word {
    std::string text;
    double left, top, right, bottom;
};

std::string told(const std::vector<std::vector<Word>>& lines) {
    const auto box = [](const Word& word) {
        return " xMin=\"" + std::to_string(word.left) + "\" yMin=\"" + std::to_string(word.top) + "\" xMax=\"" +
               std::to_string(word.right) + "\" yMax=\"" + std::to_string(word.bottom) + "\">";
    };
    std::string text =
        "<!DOCTYPE html><html><head><title>&lt;doc&gt;</title></head>\n<body>\n<doc>\n<page width=\"400\" height=\"300\"><flow>";
    for (const auto& line : lines) {
        text += "<block" + box(line.front()) + "<line" + box(line.front());
        for (const Word& word : line) text += "<word" + box(word) + word.text + "</word>";
        text += "</line></block>";
    }
    return text + "</flow></page>\n</doc>\n</body>\n</html>\n";
}

std::string use(int font, int glyph, double x, double y) {
    return "  <use xlink:href=\"#glyph" + std::to_string(font) + "-" + std::to_string(glyph) + "\" x=\"" + std::to_string(x) +
           "\" y=\"" + std::to_string(y) + "\"/>\n";
}

std::string page(const std::string& inner) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"400pt\" "
           "height=\"300pt\" "
           "viewBox=\"0 0 400 300\"><defs><symbol id=\"glyph0-1\"><path d=\"M 0 0 L 5 0 L 5 -8 Z\"/></symbol></defs>\n" +
           inner + "<path style=\"fill:none;stroke-width:2;stroke:rgb(0%,0%,0%);\" d=\"M 10 10 L 390 290 \"/>\n</svg>\n";
}

constexpr double kWidth = 200;  // mm, of what a figure is read as

std::vector<FoundWords> words_in(const std::string& svg, const std::string& text) {
    return read_svg(with_words(svg, pdf_text_of(text, "test.pdf")), "test.pdf", 0, std::nullopt, SvgPurpose::figure).words;
}

TEST(PdfText, WordsStandWhereTheirLettersWere) {
    const auto words = words_in(page("<g>\n" + use(0, 1, 150, 30) + use(0, 1, 158, 30) + use(0, 1, 233, 30) + "</g>\n"),
                                told({{{"Two &amp; three", 150, 20, 230, 33}, {"words", 233, 20, 270, 33}}}));
    ASSERT_EQ(words.size(), 1u);
    EXPECT_EQ(words[0].text, "Two & three words");
    EXPECT_NEAR(words[0].middle.x / kWidth, 210.0 / 400, 0.002);
    EXPECT_NEAR(words[0].middle.y / kWidth, 26.5 / 400, 0.006);
    EXPECT_FALSE(words[0].upwards);
}

TEST(PdfText, LettersWithoutAWordStayAsTheyAreDrawn) {
    const std::string there = use(0, 1, 150, 30), alone = use(0, 1, 50, 200);
    const std::string svg = with_words(page(there + alone), pdf_text_of(told({{{"A", 150, 20, 158, 33}}}), "test.pdf"));
    EXPECT_EQ(svg.find(there), std::string::npos);
    EXPECT_NE(svg.find(alone), std::string::npos);
}

// The numbers of an axis on one line are words apart; the pieces of a sentence are one.
TEST(PdfText, ALineEndsWhereItsGapIsNoSpace) {
    const auto words = words_in(page(use(0, 1, 50, 290) + use(0, 1, 150, 290) + use(0, 1, 250, 290)),
                                told({{{"10", 50, 280, 62, 292}, {"20", 150, 280, 162, 292}, {"30", 250, 280, 262, 292}}}));
    ASSERT_EQ(words.size(), 3u);
    EXPECT_EQ(words[1].text, "20");
    EXPECT_NEAR(words[1].middle.x / kWidth, 156.0 / 400, 0.002);
    // Over as much as part numbers the words of a justified line go on; the thousands of a number are as near as words mostly
    // are.
    const auto count = [](const std::string& first, const std::string& second, double gap) {
        const double next = 62 + gap;
        return words_in(page(use(0, 1, 50, 290) + use(0, 1, next, 290)),
                        told({{{first, 50, 280, 62, 292}, {second, next, 280, next + 12, 292}}}))
            .size();
    };
    EXPECT_EQ(count("10", "20", 7), 2u);
    EXPECT_EQ(count("to", "20", 7), 1u);
    EXPECT_EQ(count("10", "200", 3), 1u);
}

// pdftotext makes one word of letters whose gaps are all alike.
TEST(PdfText, WordsThatStandApartAreParted) {
    const auto parted = [](const std::string& word, double right,
                           const std::vector<std::pair<std::string, std::pair<double, double>>>& loose) {
        PdfText text = pdf_text_of(told({{{word, 60, 20, right, 33}}}), "test.pdf");
        std::string raw = "<doc><page width=\"400\" height=\"300\">";
        for (const auto& [part, at] : loose)
            raw += "<word xMin=\"" + std::to_string(at.first) + "\" yMin=\"20\" xMax=\"" + std::to_string(at.second) +
                   "\" yMax=\"33\">" + part + "</word>";
        part_words(text, raw + "</page></doc>", "test.pdf");
        std::string all;
        for (const PdfWord& one : text.blocks.at(0).lines.at(0).words) all += (all.empty() ? "" : " ") + one.text;
        return all;
    };
    EXPECT_EQ(parted("9V", 76, {{"9", {60, 65}}, {"V", {68.3, 76}}}), "9 V");
    EXPECT_EQ(parted("ABC", 90, {{"A", {60, 66}}, {"B", {71, 77}}, {"C", {82, 90}}}), "A B C");
    EXPECT_EQ(parted("SUN", 84, {{"S", {60, 66}}, {"U", {67.5, 74}}, {"N", {75.5, 84}}}), "SUN") << "spaced";
    EXPECT_EQ(parted("9V", 76, {{"9V", {60, 76}}}), "9V");
    EXPECT_EQ(parted("9V", 76, {{"9", {60, 65}}, {"W", {68.3, 76}}}), "9V") << "of another";
    PdfText text;
    EXPECT_THROW(part_words(text, "pdftotext: no such file", "test.pdf"), Error);
}

TEST(PdfText, ANarrowLetterWithItsIndexIsALine) {
    const std::string letters = use(0, 0, 146.5, 53) + use(1, 0, 149.4, 55);
    const auto words = words_in(page(letters), told({{{"I", 146.52, 45.2, 149.5, 54}, {"1", 149.39, 48.5, 152.9, 55.4}}}));
    ASSERT_EQ(words.size(), 1u);
    EXPECT_EQ(words[0].text, "I1");
}

TEST(PdfText, RingsAfterFiguresAreDegrees) {
    const auto text = [](const std::string& word) {
        return pdf_text_of(told({{{word, 60, 20, 90, 33}}}), "test.pdf").blocks.at(0).lines.at(0).words.at(0).text;
    };
    EXPECT_EQ(text("140\u25E6"), "140\u00B0");
    EXPECT_EQ(text("9\u2218"), "9\u00B0");
    EXPECT_EQ(text("f\u2218"), "f\u2218");
    const std::string letters = use(0, 0, 60.2, 271.3) + use(0, 1, 66.6, 271.3) + use(1, 0, 73.04, 267.4);
    EXPECT_EQ(
        words_in(page(letters), told({{{"30", 60.2, 256.2, 72.9, 275.1}, {"\u25E6", 73.04, 256.9, 77.5, 270.1}}})).at(0).text,
        "30\u00B0");
}

TEST(PdfText, ExponentsStayExponents) {
    const std::string letters = use(0, 0, 60.2, 271.3) + use(0, 1, 66.6, 271.3) + use(1, 0, 73.04, 267.4);
    const auto words = words_in(page(letters), told({{{"10", 60.2, 256.2, 72.9, 275.1}, {"3", 73.04, 256.9, 77.5, 270.1}}}));
    ASSERT_EQ(words.size(), 1u);
    EXPECT_EQ(words[0].text, "10\u00B3");
}

// Where an exponent begins just where its word ends, and where the boxes of both overlap.
TEST(PdfText, ExponentsAreTakenFromNoWordBeforeThem) {
    const std::string letters = use(0, 0, 60, 271.3) + use(0, 1, 66.6, 271.3) + use(1, 0, 73, 267.4);
    for (const double left : {73.0, 71.5})
        EXPECT_EQ(words_in(page(letters), told({{{"10", 60, 256.2, 73, 275.1}, {"6", left, 256.9, 77.5, 270.1}}})).at(0).text,
                  "10\u2076")
            << left;
    EXPECT_EQ(words_in(page(letters), told({{{"x", 60, 256.2, 73, 275.1}, {"n+1", 73, 256.9, 87.5, 270.1}}})).at(0).text,
              "x^(n+1)");
    // On a line of its own.
    EXPECT_EQ(words_in(page(letters), told({{{"10", 60, 256.2, 73, 275.1}}, {{"\u22126", 73, 256.9, 87.5, 270.1}}})).at(0).text,
              "10\u207B\u2076");
    const std::string low = use(0, 0, 60, 271.3) + use(1, 0, 68, 274) + use(0, 2, 73, 271.3);
    EXPECT_EQ(words_in(page(low), told({{{"H", 60, 256.2, 68, 275.1}, {"2", 68, 263, 72.5, 276.5}, {"O", 73, 256.2, 82, 275.1}}}))
                  .at(0)
                  .text,
              "H2O");
}

// A letter that the font has not is drawn by itself: the label is left to who reads shapes, with that letter in its place.
TEST(PdfText, LettersDrawnByThemselvesGoWithTheirLabel) {
    const auto shape_of = [](const std::string& path) {
        return "<path style=\" stroke:none;fill-rule:nonzero;fill:rgb(0%,0%,0%);fill-opacity:1;\" d=\"" + path + "\"/>\n";
    };
    const std::string shape = shape_of("M 165 20 L 169 20 L 172 25 L 172 30 L 168 30 L 165 26 Z M 165 20 ");
    const std::string svg =
        page("<g>\n" + use(0, 1, 150, 30) + use(0, 2, 158, 30) + "</g>\n" + shape + "<g>\n" + use(0, 3, 174, 30) + "</g>\n");
    const std::string label = told({{{"(k", 150, 20, 164, 33}, {")", 174, 20, 178, 33}}});
    const std::string made = with_words(svg, pdf_text_of(label, "t.pdf"));
    EXPECT_EQ(made.find("<text"), std::string::npos);
    EXPECT_EQ(made.find(shape), std::string::npos);
    const auto adopted = made.find("<use xlink:href=\"#glyph0-9");
    ASSERT_NE(adopted, std::string::npos) << made;
    EXPECT_GT(adopted, made.find("#glyph0-2\""));
    EXPECT_LT(adopted, made.find("#glyph0-3\""));
    // What is as far away as a legend's sample, as large as a thing, or a mark at a point, is none.
    for (const char* other :
         {"M 130 20 L 134 20 L 137 25 L 137 30 L 133 30 L 130 26 Z", "M 165 0 L 169 0 L 172 25 L 172 30 L 168 30 L 165 26 Z",
          "M 165 24 C 165 26 167 28 169 28 C 171 28 173 26 173 24 C 173 22 171 20 169 20 C 167 20 165 22 165 24 Z",
          "M 172 25.5 C 172 30.17 165 30.17 165 25.5 C 165 20.83 172 20.83 172 25.5", "M 165 22 L 172 22 L 172 29 L 165 29 Z"}) {
        std::string elsewhere = svg;
        elsewhere.replace(elsewhere.find(shape), shape.size(), shape_of(other));
        EXPECT_NE(with_words(elsewhere, pdf_text_of(label, "t.pdf")).find("<text"), std::string::npos) << other;
    }
}

// Whichever of two is higher on the page.
TEST(PdfText, LettersDrawnByThemselvesKeepTheirOrder) {
    const auto shape = [](int left, int top) {
        const auto at = [&](int x, int y) { return std::to_string(left + x) + " " + std::to_string(top + y); };
        return "<path style=\" stroke:none;fill:rgb(0%,0%,0%);\" d=\"M " + at(0, 0) + " L " + at(4, 0) + " L " + at(5, 4) +
               " L " + at(5, 8) + " L " + at(2, 8) + " L " + at(0, 5) + " Z\"/>\n";
    };
    const std::string text = told({{{"a", 150, 20, 158, 33}}});
    for (const int second : {19, 22}) {
        const std::string made = with_words(page("<g>\n" + use(0, 1, 150, 30) + "</g>\n" + shape(160, 21) + shape(167, second)),
                                            pdf_text_of(text, "t.pdf"));
        const auto near = made.find("x=\"160.000000\""), far = made.find("x=\"167.000000\"");
        ASSERT_NE(near, std::string::npos);
        ASSERT_NE(far, std::string::npos);
        EXPECT_LT(near, far) << second;
    }
}

TEST(PdfText, WhatNobodySeesIsNoWord) { EXPECT_TRUE(words_in(page(""), told({{{"hidden", 50, 20, 90, 33}}})).empty()); }

TEST(PdfText, LettersThatAreNoneAreLeftAsTheyAreDrawn) {
    const std::string letters = use(0, 1, 50, 30) + use(0, 2, 150, 30);
    const std::string svg =
        with_words(page(letters), pdf_text_of(told({{{"\x01\x02rm", 49, 20, 90, 33}}, {{"good", 149, 20, 180, 33}}}), "t.pdf"));
    EXPECT_NE(svg.find(use(0, 1, 50, 30)), std::string::npos);
    EXPECT_EQ(svg.find(use(0, 2, 150, 30)), std::string::npos);
}

// Matplotlib draws the minus of its numbers where its font has none.
TEST(PdfText, ABarBeforeANumberIsItsMinus) {
    const auto bar = [](double left, double top, double right, double bottom) {
        const auto at = [](double x, double y) { return std::to_string(x) + " " + std::to_string(y); };
        return "<path style=\" stroke:none;fill-rule:nonzero;fill:rgb(0%,0%,0%);fill-opacity:1;\" d=\"M " + at(left, top) +
               " L " + at(right, top) + " L " + at(right, bottom) + " L " + at(left, bottom) + " Z M " + at(left, top) +
               " \"/>\n";
    };
    const std::string letters = use(0, 0, 28.5, 268.8) + use(0, 1, 34.8, 268.8);
    const std::string number = told({{{"0.25", 28.3, 254, 50.6, 273}}}), word = told({{{"rate", 28.3, 254, 50.6, 273}}});
    const std::string minus = bar(21.2, 265.3, 27.4, 266.1);
    EXPECT_EQ(words_in(page(minus + letters), number).at(0).text, "\u22120.25");
    EXPECT_EQ(with_words(page(minus + letters), pdf_text_of(number, "test.pdf")).find(minus), std::string::npos);
    EXPECT_EQ(words_in(page(minus + letters), word).at(0).text, "");  // left to who reads shapes
    for (const std::string& other : {bar(1.2, 265.3, 7.4, 266.1), bar(2, 285.3, 8, 286.1)})
        EXPECT_EQ(words_in(page(other + letters), number).at(0).text, "0.25") << other;
}

TEST(PdfText, WordsThatRunUpAreTold) {
    const auto words = words_in(page(use(0, 1, 30, 180) + use(0, 1, 30, 133)),
                                told({{{"speed", 17, 137, 33, 180}, {"(m/s)", 17, 97, 33, 133}}}));
    ASSERT_EQ(words.size(), 1u);
    EXPECT_EQ(words[0].text, "speed (m/s)");
    EXPECT_TRUE(words[0].upwards);
}

// Boxes of slanted words hold pieces of others, and what is told of them is rubble.
TEST(PdfText, SlantedLettersAreLeftToWhoReadsShapes) {
    std::string letters;
    for (int i = 0; i < 6; ++i) letters += use(0, 1, 100 + 8 * i, 200 - 5 * i);
    const std::string svg = with_words(page("<g>\n" + letters + "</g>\n"),
                                       pdf_text_of(told({{{"Hi", 99, 180, 112, 202}}, {{"gh", 112, 176, 126, 195}}}), "t.pdf"));
    EXPECT_NE(svg.find(letters), std::string::npos);
    EXPECT_EQ(svg.find("<text"), std::string::npos);
}

TEST(PdfText, TellsWhatIsDrawn) {
    EXPECT_EQ(drawn_in(page("")), 1u);
    EXPECT_EQ(drawn_in(page("<path style=\" stroke:none;fill:rgb(100%,100%,100%);\" d=\"M 0 0 L 9 9 Z\"/>")), 1u);
    EXPECT_EQ(drawn_in(page("<path style=\" stroke:none;fill:rgb(100%,0%,0%);\" d=\"M 0 0 L 9 9 Z\"/>")), 2u);
    EXPECT_EQ(drawn_in(""), 0u);
}

TEST(PdfText, WhatIsNoneIsRefused) {
    for (const char* text : {"", "<html></html>", "<doc><page", "</doc><doc>", "<doc></page></doc>"})
        EXPECT_THROW(pdf_text_of(text, "a.pdf"), Error) << text;
    EXPECT_EQ(pdf_text_of("<doc></doc>", "a.pdf").count(), 0u);
    EXPECT_EQ(with_words("no SVG at all", {}), "no SVG at all");
}

}  // namespace
}  // namespace tactics::pdf_text_test
