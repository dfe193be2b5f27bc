// SPDX-License-Identifier: Apache-2.0
// Letters that are filled paths like any other: words if a reader takes them for print, else what is drawn.
#include "tactics/readers/svg/outlined_words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "print/letters.h"
#include "tactics/job/letter_shapes.h"
#include "tactics/readers/svg/letter_rows.h"
#include "tactics/readers/svg/svg.h"
#include "tactics/text/utf8.h"

namespace tactics::outlined_words_test {
namespace {

std::string outline(const Letter& letter, double size, double x, double y) {
    std::ostringstream d;
    for (const OutlineStep& step : letter.outline) {
        const int corners = step.kind == OutlineStep::Kind::curve ? 3 : 1;
        d << (step.kind == OutlineStep::Kind::move ? " Z M" : corners == 3 ? " C" : " L");
        for (int i = 0; i < corners; ++i)
            d << ' ' << x + step.corners[i].x * size / 1000 << ' ' << y - step.corners[i].y * size / 1000;
    }
    return d.str().empty() ? "" : d.str().substr(2) + " Z";
}

// A line of print as paths: one for all, or one for each letter.
std::string outlined(const std::string& text, double x, double y, bool each, double size = 6) {
    Page page;
    page.print.push_back({{}, 1, text});
    const auto letters = letters_of(page);
    std::string paths, all;
    for (std::string_view rest = text; !rest.empty();) {
        const Letter& letter = letters.at(take_letter(rest));
        const std::string d = outline(letter, size, x, y);
        x += letter.advance * size / 1000;
        if (each && !d.empty()) paths += "<path d='" + d + "'/>";
        all += d;
    }
    return each ? paths : "<path d='" + all + "'/>";
}

bool has_font() {
    Page page;
    page.print.push_back({{}, 1, "R"});
    return !letters_of(page).at('R').outline.empty();
}

FoundPage figure(const std::string& body, const LetterReader& read) {
    return read_svg(
        "<svg xmlns='http://www.w3.org/2000/svg' width='200mm' height='150mm' viewBox='0 0 200 150'>" + body + "</svg>",
        "figure.svg", 0, std::nullopt, SvgPurpose::figure, read);
}

const LetterReader kFonts = [](FoundPage& page) { read_letter_shapes(page); };
const LetterReader kNobody = [](FoundPage&) {};

TEST(OutlinedWords, AreReadWhetherOnePathOrMany) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    for (const bool each : {false, true}) {
        const std::string box = "<rect x='10' y='10' width='80' height='40' fill='none' stroke='black'/>";
        const FoundPage page =
            figure(box + outlined("Traits owned: i, j", 20, 30, each) + outlined("by compute", 20, 40, each), kFonts);
        ASSERT_EQ(page.words.size(), 2u) << each;
        EXPECT_EQ(page.words[0].text, "Traits owned: i, j");
        EXPECT_EQ(page.words[1].text, "by compute");
        EXPECT_NEAR(page.words[1].middle.y, 38, 1.5);
        EXPECT_EQ(page.page.strokes.size(), 1u) << "letters are no lines";
        EXPECT_TRUE(page.page.areas.empty());
    }
}

std::vector<std::string> texts_of(const FoundPage& page) {
    std::vector<std::string> texts;
    for (const FoundWords& words : page.words) texts.push_back(words.text);
    std::sort(texts.begin(), texts.end());
    return texts;
}

TEST(OutlinedWords, NumbersOfAnAxisAndItsNameAreRead) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    std::string axis = "<path d='M30,20 V120' stroke='black'/><g transform='rotate(-90 10 100)'>" +
                       outlined("Tide in metres", 10, 100, false) + "</g>";
    double y = 30;
    for (const std::string number : {"0", "6", "80", "22", "-40", "0.25"}) axis += outlined(number, 16, y += 12, true, 4);
    const FoundPage page = figure(axis, kFonts);
    EXPECT_EQ(texts_of(page), (std::vector<std::string>{"-40", "0", "0.25", "22", "6", "80", "Tide in metres"}));
    for (const FoundWords& words : page.words) EXPECT_EQ(words.upwards, words.text.starts_with('T')) << words.text;
    EXPECT_EQ(page.page.strokes.size(), 1u);
    EXPECT_TRUE(page.page.areas.empty());
}

TEST(OutlinedWords, ZerosOfTwoAxesAreTwo) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const std::string others =
        outlined("15", 60, 108, false, 4) + outlined("30", 90, 108, false, 4) + outlined("25", 24, 60, false, 4);
    const std::string zeros = outlined("0", 24, 101, false, 4) + outlined("0", 27, 105, false, 4);
    EXPECT_EQ(texts_of(figure(others + zeros, kFonts)), (std::vector<std::string>{"0", "0", "15", "25", "30"}));
}

// Larger than marks are, as letters of a small figure may be, and as some writers have it without a Z.
TEST(OutlinedWords, OfOpenPathsAreRead) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    std::string path = outlined("Dose (mg)", 20, 60, false, 12);
    for (std::size_t at; (at = path.find(" Z")) != std::string::npos;) path.erase(at, 2);
    const FoundPage page = figure(path, kFonts);
    EXPECT_EQ(texts_of(page), (std::vector<std::string>{"Dose (mg)"}));
    EXPECT_TRUE(page.page.strokes.empty());
}

TEST(OutlinedWords, HaveExponentsAndIndices) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const std::string power = outlined("10", 20, 60, false) + outlined("3", 28, 57.5, false, 4),
                      index = outlined("a", 60, 60, false) + outlined("2", 63.6, 61.5, false, 4) + outlined("b", 66, 60, false);
    EXPECT_EQ(texts_of(figure(outlined("Cells", 20, 30, false) + power + index, kFonts)),
              (std::vector<std::string>{"10³", "Cells", "a₂b"}));
}

// No row of them has three letters; together they tell their font.
TEST(OutlinedWords, OfOneOrTwoFiguresAreRead) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    std::string axis;
    double x = 0;
    for (const std::string number : {"25", "40", "37", "8"}) axis += outlined(number, x += 20, 60, false);
    EXPECT_EQ(texts_of(figure(axis, kFonts)), (std::vector<std::string>{"25", "37", "40", "8"}));
}

// Corners of a figure that has no words, and numbers below zero; a circle is no O beside them.
TEST(OutlinedWords, LettersThatStandAloneTellTheirFontTogether) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const std::string corners = outlined("A", 20, 60, false) + outlined("B", 90, 60, false) + outlined("\u22125", 55, 20, false),
                      circle = "<circle cx='150' cy='40' r='2.2'/>";
    const FoundPage page = figure(corners + circle, kFonts);
    EXPECT_EQ(texts_of(page), (std::vector<std::string>{"A", "B", "\u22125"}));
    EXPECT_EQ(page.page.areas.size() + page.page.strokes.size(),
              figure(circle, {}).page.areas.size() + figure(circle, {}).page.strokes.size());
    EXPECT_TRUE(figure(outlined("A", 20, 60, false) + outlined("B", 90, 60, false), kFonts).words.empty()) << "two are too few";
}

// As high as the capitals of a word, not as its small letters; what is higher is no letter.
TEST(OutlinedWords, ALoneCapitalIsAsHighAsThoseOfWords) {
    const auto rows_with = [](double high) {
        Glyphs glyphs;
        const auto add = [&](double left, double height) {
            const std::size_t ring = glyphs.size();
            glyphs.push_back({Box{left, 50 - height, left + 4, 50}, {ring}, 20 + ring});
        };
        add(20, 10);
        for (const double left : {25, 30, 35}) add(left, 6);
        add(120, high);
        return letter_rows(glyphs).size();
    };
    EXPECT_EQ(rows_with(10), 2u);
    EXPECT_EQ(rows_with(14), 1u);
}

// Read as print is: a bar is no figure, and letters that come apart are no words.
TEST(OutlinedWords, WhatLooksLikePrintHasTheShapesOfItsLetters) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const std::string body = outlined("Length", 20, 20, false) + outlined("10\u22122", 20, 60, false);
    const auto read_as = [&](const std::string& text) {
        const FoundPage page = figure(body, [&](FoundPage& found) {
            for (FoundWords& words : found.words) {
                words.text = words.letters.size() == 4 ? text : "Length";
                words.sureness = words.letters.size() == 4 ? 80 : 100;
            }
        });
        for (const FoundWords& words : page.words)
            if (words.letters.size() == 4) return words.text;
        return std::string("none");
    };
    EXPECT_EQ(read_as("10-2"), "10-2");
    EXPECT_EQ(read_as("1072"), "");
    EXPECT_EQ(read_as("1 a b-"), "");
}

TEST(OutlinedWords, DrawnAsTheirOutlinesAloneAreReadOrDrawn) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    std::string lines = outlined("Mon", 20, 30, true) + outlined("Tue", 60, 30, true);
    for (std::size_t at = 0; (at = lines.find("<path", at)) != lines.npos; at += 5)
        lines.insert(at + 5, " fill='none' stroke='black' stroke-width='0.2'");
    const FoundPage page = figure(lines, kFonts), unread = figure(lines, kNobody);
    EXPECT_EQ(texts_of(page), (std::vector<std::string>{"Mon", "Tue"}));
    EXPECT_TRUE(page.page.strokes.empty());
    EXPECT_TRUE(unread.words.empty());
    EXPECT_EQ(unread.page.strokes.size(), figure(lines, {}).page.strokes.size());
}

// A pale arrow that stands in the row, as large as letters, is drawn, and the words are read.
TEST(OutlinedWords, HaveOnePaint) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const std::string arrow = "<path fill='#cfe2f3' d='M40,27 l3,-3 3,3 h-1.5 v3 h-3 v-3 Z'/>";
    const FoundPage page = figure(outlined("scatter", 20, 30, false) + arrow + outlined("list", 60, 30, false), kFonts);
    EXPECT_EQ(texts_of(page), (std::vector<std::string>{"list", "scatter"}));
    EXPECT_FALSE(page.page.strokes.empty() && page.page.areas.empty());
}

TEST(OutlinedWords, InWhiteAreReadOnWhatIsDarker) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const auto light = [](const std::string& text, double x, double y) {
        return "<g fill='white'>" + outlined(text, x, y, true) + "</g>";
    };
    const std::string paper = "<rect width='200' height='150' fill='white'/>",
                      box = "<rect x='10' y='20' width='60' height='16' fill='#3060a0' stroke='black'/>";
    EXPECT_EQ(texts_of(figure(paper + box + light("Start", 20, 30), kFonts)), std::vector<std::string>{"Start"});
    EXPECT_EQ(texts_of(figure(box + light("Start", 20, 30), kFonts)), std::vector<std::string>{"Start"});
    // On paper nobody sees it, and as a halo it is no word of its own.
    EXPECT_TRUE(figure(paper + box + light("Start", 20, 80), kFonts).words.empty());
    EXPECT_EQ(texts_of(figure(paper + box + light("Start", 20, 30) + outlined("Start", 20, 30, true), kFonts)),
              std::vector<std::string>{"Start"});
}

// The sample of a curve in a legend ends with a point.
TEST(OutlinedWords, HaveNoPointBeforeThem) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const FoundPage page = figure(outlined("●Square", 20, 30, true) + outlined("Linear", 24.5, 40, true), kFonts);
    EXPECT_EQ(texts_of(page), (std::vector<std::string>{"Linear", "Square"}));
    EXPECT_EQ(page.page.strokes.size() + page.page.areas.size(), 1u) << "the point is drawn";
}

TEST(OutlinedWords, OfSingleSignsStayApart) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    EXPECT_EQ(texts_of(figure(outlined("n > 0 ?", 20, 30, false) + outlined("Traits", 20, 60, false), kFonts)),
              (std::vector<std::string>{"Traits", "n > 0 ?"}));
}

TEST(OutlinedWords, WithALineAroundEachLetterAreReadOnce) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const FoundPage page = figure("<g stroke='black' stroke-width='0.2'>" + outlined("Odd boxes", 20, 30, true) + "</g>", kFonts);
    EXPECT_EQ(texts_of(page), std::vector<std::string>{"Odd boxes"});
    EXPECT_TRUE(page.page.strokes.empty());
    EXPECT_TRUE(page.page.areas.empty());
}

TEST(OutlinedWords, ThatStandApartEvenlyAreOneWord) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const std::string spaced = outlined("B", 20, 30, true) + outlined("o", 26, 30, true) + outlined("b", 32, 30, true);
    EXPECT_EQ(texts_of(figure(spaced + outlined("Traits owned", 20, 50, false), kFonts)),
              (std::vector<std::string>{"Bob", "Traits owned"}));
}

TEST(OutlinedWords, NobodyReadsAreDrawn) {
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    const std::string body = outlined("Traits owned", 20, 30, false);
    const auto ink = [](const FoundPage& page) {
        double length = 0;
        for (const PageStroke& stroke : page.page.strokes) length += length_of(Stroke{stroke.points, stroke.closed});
        for (const Area& area : page.page.areas)
            for (const auto& ring : area.rings) length += length_of(Stroke{ring, true});
        return length;
    };
    const FoundPage back = figure(body, kNobody);
    EXPECT_TRUE(back.words.empty());
    EXPECT_NEAR(ink(back), ink(figure(body, {})), 1e-9);
    EXPECT_GT(ink(back), 50);
    // What a reader saw, or what stands among words that were read, is told of and not drawn.
    const FoundPage seen = figure(body, [](FoundPage& page) { page.words.back().seen = true; });
    ASSERT_EQ(seen.words.size(), 1u);
    EXPECT_EQ(ink(seen), 0);
    const FoundPage among =
        figure(body + outlined("by compute", 20, 40, false), [](FoundPage& page) { page.words.back().text = "by compute"; });
    EXPECT_EQ(among.words.size(), 2u);
    EXPECT_EQ(ink(among), 0);
}

TEST(OutlinedWords, RowsOfPointsAndFewShapesAreNone) {
    std::string points;
    for (int i = 0; i < 12; ++i) points += "<circle cx='" + std::to_string(20 + 4 * i) + "' cy='40' r='1'/>";
    EXPECT_TRUE(figure(points, kFonts).words.empty());
    const std::size_t drawn = figure(points, {}).page.areas.size();
    if (!has_font()) GTEST_SKIP() << "no font is installed";
    EXPECT_EQ(figure(points + outlined("Traits", 20, 60, false), kFonts).page.areas.size(), drawn);
    EXPECT_TRUE(figure(outlined("RQ", 20, 30, true), kFonts).words.empty());
    EXPECT_FALSE(figure(outlined("RQRQRQ", 20, 30, true), kFonts).words.empty());
}

}  // namespace
}  // namespace tactics::outlined_words_test
