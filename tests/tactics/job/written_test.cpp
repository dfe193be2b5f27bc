// SPDX-License-Identifier: Apache-2.0
// Paragraphs and headings of pages as pdftotext tells them, and of text files.
#include "tactics/job/written.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tactics/job/pdf_paragraphs.h"
#include "tactics/text/words.h"

namespace tactics {
namespace {

using Kind = TextBlock::Kind;

// Words of half their height a letter, parted by a third of it.
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
    // Of all pages together: a title page has no usual height of its own.
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
}  // namespace tactics
