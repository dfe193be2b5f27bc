// SPDX-License-Identifier: Apache-2.0
// Paragraphs and headings of pages as pdftotext tells them, and of text files.
#include "tactics/job/written.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tactics/job/pdf_paragraphs.h"
#include "tactics/text/words.h"

namespace tactics::written_test {
namespace {

using Kind = TextBlock::Kind;

// Words with letters half as wide as high, separated by a third of the height.
PdfLine line(double left, double top, double high, const std::string& text) {
    PdfLine made;
    for (const std::string_view word : words_of(std::string_view(text))) {
        const double width = 0.5 * high * static_cast<double>(word.size());
        made.words.push_back({std::string(word), {left, top, width, high}});
        left += width + high / 3;
    }
    return made;
}

PdfBlock block(double top, double high, const std::vector<std::string>& lines) {
    PdfBlock made;
    for (const std::string& text : lines) made.lines.push_back(line(30, top += 1.25 * high, high, text));
    return made;
}

PdfText page(std::vector<PdfBlock> blocks) { return {400, 300, std::move(blocks)}; }

const std::vector<std::string> kBody = {"this is the body of the page", "which has lines of several words",
                                        "and ends with this one"};

// "h:heading p:paragraph".
std::string told(const std::vector<TextBlock>& blocks) {
    std::string text;
    for (const TextBlock& one : blocks) text += (one.kind == Kind::heading ? "h:" : "p:") + one.text + "|";
    return text;
}
std::string told(const std::vector<PdfText>& pages) {
    PartedWords parted;
    return told(paragraphs_of(pages, parted));
}

TEST(Written, TheUsualHeightIsThatOfMostWords) {
    EXPECT_EQ(usual_height({}), 0);
    EXPECT_EQ(usual_height({page({block(0, 20, {"a large heading"}), block(50, 12, kBody)})}), 12);
    // For all pages together: a title page has no usual height of its own.
    EXPECT_EQ(usual_height({page({block(0, 20, {"a title"})}), page({block(0, 12, kBody)})}), 12);
}

TEST(Written, LargeLinesAreHeadings) {
    EXPECT_EQ(told({page({block(0, 20, {"a heading"}), block(50, 12, kBody)})}),
              "h:a heading|p:this is the body of the page which has lines of several words and ends with this one|");
    EXPECT_EQ(told({page({block(0, 20, {"one heading", "of two lines"}), block(90, 12, kBody)})}).substr(0, 26),
              "h:one heading of two lines");
}

TEST(Written, FourLinesOrAThirdOfAllWordsAreNoHeading) {
    std::vector<std::string> much;
    for (int i = 0; i < 20; ++i) much.insert(much.end(), kBody.begin(), kBody.end());
    EXPECT_TRUE(told({page({block(0, 20, {"a", "b", "c", "d"}), block(90, 12, much)})}).starts_with("p:a b c d|"));
    EXPECT_TRUE(told({page({block(0, 20, {"a", "b", "c"}), block(90, 12, much)})}).starts_with("h:a b c|"));
    EXPECT_TRUE(told({page({block(0, 20, {"a heading"}), block(50, 12, {"five words of plain text"})})}).starts_with("h:"));
    EXPECT_TRUE(told({page({block(0, 20, {"a heading"}), block(50, 12, {"three words only"})})}).starts_with("p:"));
}

TEST(Written, ALineThatIsMovedInBeginsAParagraph) {
    PdfBlock both = block(0, 12, kBody);
    both.lines[2] = line(45, both.lines[2].words[0].box.top, 12, "and ends with this one");
    EXPECT_EQ(told({page({both})}), "p:this is the body of the page which has lines of several words|p:and ends with this one|");
}

TEST(Written, AWordThatIsPartedAtTheEndOfAPageIsOne) {
    EXPECT_EQ(told({page({block(0, 12, {"about an exam-"})}), page({block(0, 12, {"ple that goes on"})})}),
              "p:about an example that goes on|");
    EXPECT_EQ(told({page({block(0, 12, {"about an end."})}), page({block(0, 12, {"and so on"})})}),
              "p:about an end.|p:and so on|");
}

TEST(Written, APageOfTextHasManyWordsInLines) {
    const PdfText text = page({block(0, 12, std::vector<std::string>(6, "five words of plain text"))});
    EXPECT_TRUE(is_text(text, 0));
    EXPECT_TRUE(is_text(text, 100));
    EXPECT_FALSE(is_text(page({}), 0));
    EXPECT_TRUE(is_text(page({block(0, 12, {"label"})}), 0));
    EXPECT_FALSE(is_text(page({block(0, 12, {"label"})}), 1));
    EXPECT_FALSE(is_text(page({block(0, 12, std::vector<std::string>(50, "two words"))}), 1));
    EXPECT_FALSE(is_text(page({block(0, 12, std::vector<std::string>(5, "five words of plain text"))}), 1));  // 25 words
    // Names in one line each, beside what they name.
    std::vector<PdfBlock> names;
    for (int i = 0; i < 7; ++i) names.push_back(block(40.0 * i, 12, {"North America; 3.8 billion tons"}));
    EXPECT_TRUE(is_text(page(names), 10));
    EXPECT_FALSE(is_text(page(names), 100));
}

// Words of Helvetica, of one size and on one base line each.
struct Set {
    std::string text;
    double gap, size, up;  // behind the word before, points, over the line
};
std::string words_in(const std::vector<Set>& words) {
    PdfLine made;
    double left = 30;
    for (const Set& word : words) {
        const double width = 0.55 * word.size * static_cast<double>(word.text.size());
        left += word.gap;
        made.words.push_back({word.text, {left, 200 - word.up - 0.718 * word.size, width, 0.925 * word.size}});
        left += width;
    }
    return words_of(made);
}

TEST(Written, ExponentsAndIndicesStayWithTheirWords) {
    EXPECT_EQ(words_in({{"area", 0, 12, 0}, {"x", 3.3, 12, 0}, {"2", 0.5, 7, 5}, {"+", 3.3, 12, 0}, {"y", 3.3, 12, 0}}),
              "area x\u00B2 + y");
    EXPECT_EQ(words_in({{"10", 0, 12, 0}, {"-6", 0, 8, 5}, {"m", 3.3, 12, 0}}), "10\u207B\u2076 m");
    EXPECT_EQ(words_in({{"x", 0, 12, 0}, {"n+1", 0, 8, 5}, {"ends", 3.3, 12, 0}}), "x^(n+1) ends");
    EXPECT_EQ(words_in({{"CO", 0, 12, 0}, {"2", 0, 8, -3}, {"and", 3.3, 12, 0}, {"x", 3.3, 12, 0}, {"i", 0, 8, -3}}),
              "CO2 and x_(i)");
    EXPECT_EQ(words_in({{"the", 0, 12, 0}, {"4", 3.3, 12, 0}, {"th", 0, 8, 5}, {"of", 3.3, 12, 0}}), "the 4th of");
    EXPECT_EQ(words_in({{"1", 0, 8, 5}, {"A", 0.5, 12, 0}, {"note", 3.3, 12, 0}}), "\u00B9A note");
    EXPECT_EQ(words_in({{"x", 0, 12, 0}, {"2", 6, 7, 5}}), "x \u00B2");  // parted as it is
}

TEST(Written, WordsOfOtherSizesOnALineAreNoExponents) {
    EXPECT_EQ(words_in({{"H", 0, 14, 0}, {"EADING", 0, 10, 0}, {"small", 3.3, 10, 0}}), "HEADING small");
    EXPECT_EQ(words_in({{"Note", 0, 12, 0}, {":", 0, 12, 0}, {"read", 3.3, 12, 0}}), "Note: read");
    EXPECT_EQ(words_in({{"one", 0, 12, 0}, {"over", -15, 12, 0}, {"the", 3.3, 12, 0}}), "one over the");
    EXPECT_EQ(words_in({{"olam", 0, 12, 0}, {"shalom", -75, 12, 0}}), "olam shalom");  // from right to left
    EXPECT_EQ(words_in({{"T", 0, 40, -24}, {"his", 1, 12, 0}, {"is", 3.3, 12, 0}}), "This is");
}

std::string told(std::string_view text) { return told(written_in_text(text).blocks); }

TEST(Written, TextFilesHaveParagraphsAndLists) {
    EXPECT_EQ(told("one\ntwo\n\nthree\n- four\n- five"), "p:one two|p:three|p:- four|p:- five|");
    EXPECT_EQ(told("write an e-\nmail\r\nto us"), "p:write an e-mail to us|");
    EXPECT_EQ(told(""), "");
    EXPECT_EQ(told("1. one\n12) two\nin\n1999. Then\n3.14 is pi"), "p:1. one|p:12) two in 1999. Then 3.14 is pi|");
    EXPECT_EQ(told("1.\tone\n-\ttwo\n\u2022\tthree"), "p:1.\tone|p:-\ttwo|p:\u2022\tthree|");
    EXPECT_TRUE(written_in_text("\tmoved in\nby a tab").notes.empty());
}

TEST(Written, HeadingsOfTextFilesHaveABlankOrARule) {
    EXPECT_EQ(told("# one\n###### two\n#\tthree"), "h:one|h:two|h:three|");
    EXPECT_EQ(told("#1 in sales, #hashtag\n#2 of many"), "p:#1 in sales, #hashtag #2 of many|");
    EXPECT_EQ(told("####### seven"), "p:####### seven|");
    EXPECT_EQ(told("one\n===\ntwo\n---\nthree"), "h:one|h:two|p:three|");
    EXPECT_EQ(told("a paragraph\nof two lines\n-----\nnext"), "p:a paragraph of two lines|p:-----|p:next|");
    EXPECT_EQ(told("- milk\n-----"), "p:- milk|p:-----|");
}

TEST(Written, CellsOfRowsStayApart) {
    const std::string_view table = "Name\tPrice\tQty\nApples\t3\t12\nPears\t\t7\nPlums\t2\t\n\t\t9\nand so\non";
    EXPECT_EQ(written_in_text(table).notes.size(), 1u);
    // How many bars a row has is how many tabs it has, empty cells or not.
    for (const TextBlock& row : written_in_text(table).blocks)
        if (row.text.find("and so") == row.text.npos && row.text.find('9') == row.text.npos) {
            EXPECT_EQ(std::count(row.text.begin(), row.text.end(), '|'), 2) << row.text;
        }
    EXPECT_EQ(written_in_text(table).blocks.size(), 6u);
    EXPECT_EQ(written_in_text(table).blocks.back().text, "and so on");
}

}  // namespace
}  // namespace tactics::written_test
