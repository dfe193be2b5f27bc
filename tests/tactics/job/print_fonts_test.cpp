// SPDX-License-Identifier: Apache-2.0
// Print of figures read by two readers: pages of our own print, painted as programs paint figures, and what is believed of it.
#include "tactics/job/print_fonts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "print/format.h"
#include "tactics/lettering/lettering.h"
#include "tactics/readers/read.h"
#include "tests/cli/tool.h"

namespace tactics::print_fonts_test {
namespace {

struct Label {
    double x, y, size;  // mm
    std::string text;
};

// A page in grey, at 150 dpi as figures have it.
Image picture_of(const std::vector<Label>& labels, const std::vector<PageStroke>& strokes = {}, int width = 650) {
    Page page;
    page.width = 110;
    page.height = 70;
    for (const Label& one : labels) page.print.push_back({{one.x, one.y}, one.size, one.text});
    page.strokes = strokes;
    const Format& png = *find_format("png");
    Settings settings(png.options);
    settings.set("dpi", "600", "test", "png");
    const std::string bytes = png.encode(page, settings);
    Source source = memory_source({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, "page.png");
    return read_picture(source, {width, false});  // made smaller, letters fade into the ground
}

// What stands, and in brackets what is told.
std::vector<std::string> words_in(const Image& image, const std::string& program = "tesseract") {
    const Lettering lettering = read_lettering(image, "en", kSureEnough, each_print_font, program);
    std::vector<std::string> words;
    if (!lettering.trouble.empty()) words.push_back("trouble: " + lettering.trouble.english());
    for (const PrintedWords& one : lettering.words) words.push_back(one.sure ? one.text : "(" + one.text + ")");
    std::sort(words.begin(), words.end());
    return words;
}

using Expected = std::vector<std::string>;

bool is_same(const FontShape& a, const FontShape& b) {
    if (a.advance != b.advance || a.rings.size() != b.rings.size()) return false;
    for (std::size_t i = 0; i < a.rings.size(); ++i)
        if (!std::equal(a.rings[i].begin(), a.rings[i].end(), b.rings[i].begin(), b.rings[i].end(),
                        [](Point p, Point q) { return p.x == q.x && p.y == q.y; }))
            return false;
    return true;
}

// Latin Modern, as TeX has it: its letters for formulas are in another file, under other codes.
TEST(FontsOfFormulas, SlantLettersAndNothingElse) {
    const std::vector<char32_t> codes{U'1', U'x', U'h', U'=', U'\u03b1'};
    bool any = false;
    each_print_font(codes, [&](const PrintFont& font) {
        if (!font.formula) return true;
        const FontShapes formula = font.formula(codes), plain = font.more(codes);
        if (!formula.contains(U'h') || !plain.contains(U'h') || is_same(formula.at(U'h'), plain.at(U'h'))) return true;
        any = true;
        EXPECT_TRUE(formula.contains(U'x'));
        EXPECT_TRUE(is_same(formula.at(U'1'), plain.at(U'1')) && is_same(formula.at(U'='), plain.at(U'=')));
        return true;
    });
    if (!any) GTEST_SKIP() << "no font with slanted letters is installed";
}

class PrintFonts : public testing::Test {
protected:
    void SetUp() override {
        bool any = false;
        each_print_font({U'a'}, [&](const PrintFont& font) {
            any = !font.shapes.empty();
            return false;
        });
        if (!any) GTEST_SKIP() << "no font is installed";
        const Lettering asked = read_lettering(picture_of({{20, 20, 5, "Water"}}), "en", kSureEnough);
        if (!asked.trouble.empty()) GTEST_SKIP() << asked.trouble.english();
    }
};

TEST_F(PrintFonts, LabelsThatReadersOfPrintGetWrongAreRight) {
    const Image image = picture_of({{20, 12, 4.2, "Current and voltage"},
                                    {20, 24, 4.2, "R = 10 \u03a9"},
                                    {60, 24, 4.2, "q0"},
                                    {80, 24, 4.2, "q1"},
                                    {20, 36, 4.2, "cos x"},
                                    {60, 36, 4.2, "\u22125 \u00b0C"},
                                    {20, 48, 4.2, "n > 0 ?"},
                                    {60, 48, 4.2, "\u03b1 = 30\u00b0"}});
    EXPECT_EQ(words_in(image), (Expected{"Current and voltage", "R = 10 \u03a9", "cos x", "n > 0 ?", "q0", "q1",
                                         "\u03b1 = 30\u00b0", "\u22125 \u00b0C"}));
}

TEST_F(PrintFonts, LettersAndDigitsThatStandAloneAreSetWhereTheyAreOfTheSizeOfWords) {
    const Image image = picture_of({{20, 12, 4.2, "Triangle"},
                                    {20, 30, 4.2, "A"},
                                    {60, 30, 4.2, "B"},
                                    {40, 20, 4.2, "C"},
                                    {20, 50, 4.2, "4"},
                                    {40, 50, 4.2, "6"},
                                    {60, 50, 4.2, "8"},
                                    {90, 50, 9.5, "R"}});
    const auto words = words_in(image);
    for (const std::string text : {"Triangle", "A", "B", "C", "4", "6", "8"})
        EXPECT_NE(std::find(words.begin(), words.end(), text), words.end()) << text;
    EXPECT_EQ(std::find(words.begin(), words.end(), "R"), words.end());  // of a size that no word has
}

// As an array is drawn: each letter in its box, each number below.
TEST_F(PrintFonts, LettersInARowOfBoxesAndNumbersOfAnotherSizeNeedNoWords) {
    std::vector<Label> labels;
    std::vector<PageStroke> boxes;
    const std::string letters = "AEBKR", numbers = "23468";
    for (std::size_t i = 0; i < letters.size(); ++i) {
        const double left = 10 + 8.0 * static_cast<double>(i);
        labels.push_back({left + 2.5, 20, 4.2, letters.substr(i, 1)});
        labels.push_back({left + 3, 30, 3.1, numbers.substr(i, 1)});
        boxes.push_back({{{left, 14.5}, {left + 8, 14.5}, {left + 8, 22.5}, {left, 22.5}}, true, 0.3});
    }
    EXPECT_EQ(words_in(picture_of(labels, boxes)), (Expected{"2", "3", "4", "6", "8", "A", "B", "E", "K", "R"}));
}

// Painted thick, they match no font well, but one in one size.
TEST_F(PrintFonts, FourLettersNeedNoWords) {
    const std::vector<Label> letters{{20, 30, 4.2, "A"}, {60, 30, 4.2, "B"}, {40, 20, 4.2, "R"}, {50, 50, 4.2, "E"}};
    EXPECT_EQ(words_in(picture_of(letters)), (Expected{"A", "B", "E", "R"}));
}

TEST_F(PrintFonts, CirclesAndStrokesAreNoLetters) {
    std::vector<PageStroke> marks;
    for (const double x : {30.0, 50.0, 70.0}) {
        PageStroke circle{{}, true, 0.3};
        for (int i = 0; i < 24; ++i) circle.points.push_back({x + 1.1 * std::cos(i * 0.2618), 40 + 1.1 * std::sin(i * 0.2618)});
        marks.push_back(circle);
        marks.push_back({{{x, 50}, {x, 53}}, false, 0.4});
        marks.push_back({{{x - 1, 60}, {x + 1, 60}}, false, 0.4});
    }
    EXPECT_EQ(words_in(picture_of({{20, 12, 4.2, "Height of plants"}}, marks)), (Expected{"Height of plants"}));
}

TEST_F(PrintFonts, AWordWhoseFirstLetterIsHiddenIsToldAndNotSet) {
    const std::vector<Label> labels{{20, 12, 4.2, "Flow chart"}, {50, 30, 4.2, "takes"}};
    EXPECT_EQ(words_in(picture_of(labels)), (Expected{"Flow chart", "takes"}));
    const auto words = words_in(picture_of(labels, {{{{48, 25}, {50.7, 25}, {50.7, 32}, {48, 32}}, true, 0.3}}));
    ASSERT_EQ(words.size(), 2u);
    EXPECT_EQ(words[0].front(), '(') << words[0];
    EXPECT_EQ(words[1], "Flow chart");
}

Image turned_left(const Image& level) {
    const Image grey = to_grey(level);
    Image climbing = make_image(level.height, level.width, 1, 0, 255);
    for (int y = 0; y < level.height; ++y)
        for (int x = 0; x < level.width; ++x) climbing.row(level.width - 1 - x)[y] = grey.row(y)[x];
    return climbing;
}

TEST_F(PrintFonts, NumbersThatClimbAreReadAsTheyStand) {
    const Image level = picture_of({{20, 12, 4.2, "Number"}, {50, 12, 4.2, "10"}, {80, 12, 4.2, "15"}});
    EXPECT_EQ(words_in(turned_left(level)), (Expected{"10", "15", "Number"}));
}

// The unit of an axis has no other print in its column.
TEST_F(PrintFonts, AUnitThatClimbsIsRead) {
    const Image level = picture_of({{20, 12, 4.2, "Number"}, {60, 40, 4.2, "mm"}, {90, 40, 4.2, "oo"}});
    const Expected words = words_in(turned_left(level));
    EXPECT_EQ(std::count(words.begin(), words.end(), "mm"), 1);
    EXPECT_EQ(std::count(words.begin(), words.end(), "oo"), 0) << "rings may stand above each other";
}

// A reader of print that says the same of everything.
TEST_F(PrintFonts, WhatIsReadAndLooksUnlikeTheInkIsNotSet) {
    const tests::Folder folder;
    std::string table = "cat > /dev/null\n";
    for (int page = 1; page <= 2; ++page)
        table += "printf '5\\t" + std::to_string(page) + "\\t1\\t1\\t1\\t1\\t0\\t0\\t9\\t9\\t95\\tWinter\\n'\n";
    tests::write_bytes(folder / "reader", "#!/bin/sh\n" + table);
    std::filesystem::permissions(folder / "reader", std::filesystem::perms::owner_all);
    const std::string reader = (folder / "reader").string();
    EXPECT_EQ(words_in(picture_of({{20, 20, 5, "Winter"}}), reader), (Expected{"Winter"}));
    EXPECT_EQ(words_in(picture_of({{20, 20, 5, "Summer"}}), reader), (Expected{"Summer"}));
}

// Figures of the web: 10 pt at 72 to 100 dpi, in which a point or a stem is less than a pixel. What is set is there, and most is
// set.
TEST_F(PrintFonts, OfSmallPrintMostIsSetAndNothingWrong) {
    constexpr double kSize = 3.53;  // mm: 10 pt
    const std::vector<std::string> texts{"Density", "Number of pupils", "0.00", "0.25", "0.50", "0.75", "1.00", "10",
                                         "100",     "\u22125",          "1.0",  "-2.5"};
    std::vector<Label> labels;
    for (std::size_t i = 0; i < texts.size(); ++i)
        labels.push_back({10.0 + 50.3 * static_cast<double>(i % 2), 8.0 + 10.7 * static_cast<double>(i / 2), kSize, texts[i]});
    for (const int dpi : {72, 80, 90, 100}) {
        std::size_t set = 0;
        for (const std::string& one : words_in(picture_of(labels, {}, 110 * dpi / 254 * 10))) {
            if (one.front() == '(') continue;
            ++set;
            const bool is_there = std::find(texts.begin(), texts.end(), one) != texts.end() || one == "\u22122.5";
            EXPECT_TRUE(is_there) << dpi << " dpi: " << one;
        }
        EXPECT_GE(2 * set, texts.size()) << dpi;
    }
}

// In print of few pixels a bracket alone may be anything. Its partner may stand in what goes on behind a colon or a sign.
TEST_F(PrintFonts, WhatStandsBetweenTwoBracketsIsOneLabel) {
    constexpr double kSize = 3.53;  // mm: 10 pt
    const auto set = [&](const std::string& text, int dpi) {
        const Image image = picture_of({{10, 8, kSize, "Density"}, {60, 8, kSize, "Area"}, {10, 30, kSize, text}}, {},
                                       static_cast<int>(110 * dpi / 25.4));
        const auto words = words_in(image);
        return std::find(words.begin(), words.end(), text) != words.end();
    };
    for (const int dpi : {90, 100, 150}) EXPECT_TRUE(set("Forest (area = 0.98)", dpi)) << dpi;
    EXPECT_TRUE(set("Rate (class: Tree)", 150));
    EXPECT_FALSE(set("Rate (class", 90));
    EXPECT_TRUE(set("Rate class", 90));
}

// A word that runs out of the picture, and one with a sign that no font was asked for.
TEST_F(PrintFonts, WhatIsCutOffOrHasAStrangeSignIsNotSet) {
    const Image image = picture_of({{20, 12, 4.2, "Flow chart"}, {100.5, 30, 4.2, "Winter"}, {30, 50, 4.2, "speed_max"}});
    for (const std::string& one : words_in(image))
        EXPECT_TRUE(one == "Flow chart" || one.front() == '(' || one == "speed_max") << one;
}

// Print beyond doubt that is not set is taken out of the lines.
TEST_F(PrintFonts, PrintThatIsNotSetLeavesTheLinesAndMarksStay) {
    std::vector<PageStroke> marks;
    for (const double x : {70.0, 80.0, 90.0}) marks.push_back({{{x, 40}, {x + 2, 43}, {x - 2, 43}}, true, 0.3});
    marks.push_back({{{48, 25}, {50.7, 25}, {50.7, 32}, {48, 32}}, true, 0.3});  // over the first letter
    const Image image = picture_of({{20, 12, 4.2, "Flow chart"}, {50, 30, 4.2, "takes"}}, marks);
    const Lettering lettering = read_lettering(image, "en", kSureEnough, each_print_font);
    Image left = image;
    take_out(left, lettering, true);
    EXPECT_TRUE(std::any_of(lettering.words.begin(), lettering.words.end(), [](const PrintedWords& one) { return one.out; }));
    for (const PrintedWords& one : lettering.words)
        if (one.out) {
            EXPECT_FALSE(one.sure);
            for (const InkRun& run : one.ink)
                for (int x = run.left; x < run.right; ++x) EXPECT_GT(left.row(run.y)[x], 128);
        }
    const int top = 39 * 650 / 110, bottom = 44 * 650 / 110;
    for (int y = top; y < bottom; ++y)
        for (int x = 68 * 650 / 110; x < 93 * 650 / 110; ++x) EXPECT_EQ(left.row(y)[x], image.row(y)[x]);
}

// "6" of "6 takes", where a line runs through the word; farther off it is a number by itself.
TEST_F(PrintFonts, ANumberIsNotSetWithoutItsUnit) {
    const auto is_set = [](double x) {
        const std::vector<PageStroke> line{{{{x + 8.7, 22}, {x + 8.7, 42}}, false, 0.3}};
        const Expected words =
            words_in(picture_of({{20, 12, 4.2, "Flow chart"}, {20, 30, 4.2, "6"}, {x, 30, 3.6, "takes"}}, line));
        return std::find(words.begin(), words.end(), "6") != words.end();
    };
    EXPECT_FALSE(is_set(25.7));
    EXPECT_TRUE(is_set(28));
}

// "water" of "takes water", in print with wide gaps, where a line runs through the first word.
TEST_F(PrintFonts, ALabelIsNotSetInPart) {
    const auto is_set = [](double x) {
        const std::vector<PageStroke> line{{{{20.2, 22}, {20.2, 42}}, false, 0.3}};
        const Expected words =
            words_in(picture_of({{20, 12, 4.2, "Flow chart"}, {20, 30, 4.2, "takes"}, {x, 30, 4.2, "water"}}, line));
        return std::find(words.begin(), words.end(), "water") != words.end();
    };
    EXPECT_TRUE(is_set(60));
    EXPECT_FALSE(is_set(34.2));
}

// Its degree sign touches a line, and is a part of that.
TEST_F(PrintFonts, AFigureWhoseSignIsHiddenIsTold) {
    const auto is_set = [](double x) {
        const std::vector<PageStroke> slanted{{{{x - 6, 18}, {x + 6, 34}}, false, 0.3}};
        const Expected words = words_in(picture_of({{20, 12, 4.2, "a = 5 cm"}, {50, 30, 4.2, "37\u00b0"}}, slanted));
        return std::find(words.begin(), words.end(), "37\u00b0") != words.end() ? 1
               : std::find(words.begin(), words.end(), "37") != words.end()     ? -1
                                                                                : 0;
    };
    EXPECT_EQ(is_set(70), 1);
    for (double x = 55; x < 60; x += 0.25) EXPECT_NE(is_set(x), -1) << x;
}

// "10.5" with the frame of a plot through its point, and a word through which an axis runs.
TEST_F(PrintFonts, WhatALineRunsThroughIsTold) {
    const auto set_with = [](const std::string& text, const PageStroke& line) {
        Expected words = words_in(picture_of({{20, 12, 4.2, "Flow chart"}, {50, 30, 4.2, text}}, {line}));
        std::erase_if(words, [](const std::string& one) { return one.front() == '(' || one == "Flow chart"; });
        return words;
    };
    const auto upright_at = [](double x) { return PageStroke{{{x, 20}, {x, 40}}, false, 0.3}; };
    EXPECT_EQ(set_with("10.5", upright_at(80)), Expected{"10.5"});
    for (double x = 54.6; x < 57; x += 0.2) EXPECT_EQ(set_with("10.5", upright_at(x)), Expected{}) << x;
    EXPECT_EQ(set_with("Rain fall", {{{2, 34}, {100, 34}}, false, 0.3}), Expected{"Rain fall"}) << "below it";
    for (double x = 50.5; x < 66; x += 1) {
        const Expected words = set_with("Rain fall", upright_at(x));
        EXPECT_TRUE(words.empty() || words == Expected{"fall"} || words == Expected{"Rain fall"}) << x << " " << words.front();
    }
}

// Messages of a sequence diagram stand right above their dotted arrows; of a few low lines one may be of a letter.
TEST_F(PrintFonts, ADottedLineRightBelowIsNoSign) {
    const auto is_set = [](int dots, double first = 40) {
        std::vector<PageStroke> line;
        for (int i = 0; i < dots; ++i) line.push_back({{{first + 1.2 * i, 31}, {first + 0.3 + 1.2 * i, 31}}, false, 0.3});
        const Expected words = words_in(picture_of({{20, 12, 4.2, "Flow chart"}, {50, 30, 4.2, "Rain fall"}}, line));
        return std::find(words.begin(), words.end(), "Rain fall") != words.end();
    };
    EXPECT_TRUE(is_set(50));
    EXPECT_TRUE(is_set(0));
    EXPECT_TRUE(is_set(10)) << "one of them below it";
    EXPECT_FALSE(is_set(4, 47.2)) << "too few for a row";
}

// The last letter of a word whose others are hidden.
TEST_F(PrintFonts, ALetterRightBesideStrangeInkIsNone) {
    const auto is_set = [](double away) {
        const std::vector<PageStroke> slanted{{{{57 - away, 20}, {63 - away, 37.6}}, false, 0.3}};
        const Expected words =
            words_in(picture_of({{20, 12, 4.2, "Flow chart"}, {20, 50, 4.2, "takes"}, {60, 30, 4.2, "k"}}, slanted));
        return std::find(words.begin(), words.end(), "k") != words.end();
    };
    EXPECT_TRUE(is_set(4));
    EXPECT_FALSE(is_set(1.4));
}

}  // namespace
}  // namespace tactics::print_fonts_test
