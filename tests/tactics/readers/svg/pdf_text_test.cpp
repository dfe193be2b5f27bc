// SPDX-License-Identifier: Apache-2.0
// Words of a PDF in the place of the letters that pdftocairo drew. What both programs write was taken from poppler 22.12.
#include "tactics/readers/svg/pdf_text.h"

#include <gtest/gtest.h>

#include "tactics/error.h"
#include "tactics/readers/svg/cairo_glyphs.h"
#include "tactics/readers/svg/svg.h"

namespace tactics {
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

std::vector<FoundWords> words_in(const std::string& svg, const std::string& text) {
    return read_svg(with_words(svg, pdf_text_of(text, "test.pdf")), "test.pdf", 0, std::nullopt, SvgPurpose::figure).words;
}

TEST(PdfText, WordsStandWhereTheirLettersWere) {
    const auto words = words_in(page("<g>\n" + use(0, 1, 150, 30) + use(0, 1, 158, 30) + "</g>\n"),
                                told({{{"Two &amp; three", 150, 20, 230, 33}, {"words", 233, 20, 270, 33}}}));
    ASSERT_EQ(words.size(), 1u);
    EXPECT_EQ(words[0].text, "Two & three words");
    EXPECT_NEAR(words[0].middle.x, 210 * 25.4 / 72, 0.5);
    EXPECT_NEAR(words[0].middle.y, 26.5 * 25.4 / 72, 1);
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
    const auto words =
        words_in(page(""), told({{{"10", 50, 280, 62, 292}, {"20", 150, 280, 162, 292}, {"30", 250, 280, 262, 292}}}));
    ASSERT_EQ(words.size(), 3u);
    EXPECT_EQ(words[1].text, "20");
    EXPECT_NEAR(words[1].middle.x, 156 * 25.4 / 72, 0.5);
}

TEST(PdfText, ExponentsStayExponents) {
    const std::string letters = use(0, 0, 60.2, 271.3) + use(0, 1, 66.6, 271.3) + use(1, 0, 73.04, 267.4);
    const auto words = words_in(page(letters), told({{{"10", 60.2, 256.2, 72.9, 275.1}, {"3", 73.04, 256.9, 77.5, 270.1}}}));
    ASSERT_EQ(words.size(), 1u);
    EXPECT_EQ(words[0].text, "10\u00B3");
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
    EXPECT_EQ(words_in(page(minus + letters), word).at(0).text, "rate");
    for (const std::string& other :
         {bar(21.2, 268.9, 27.4, 269.7), bar(1.2, 265.3, 27.4, 266.1), bar(21.2, 260, 27.4, 266), bar(2, 265.3, 8, 266.1)})
        EXPECT_EQ(words_in(page(other + letters), number).at(0).text, "0.25") << other;
}

TEST(PdfText, WordsThatRunUpAreTold) {
    const auto words = words_in(page(""), told({{{"speed", 17, 137, 33, 180}, {"(m/s)", 17, 97, 33, 133}}}));
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
}  // namespace tactics
