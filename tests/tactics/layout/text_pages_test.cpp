// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/text_pages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/text/utf8.h"

namespace tactics::text_pages_test {
namespace {

using Kind = TextBlock::Kind;
using Cells = std::vector<std::uint8_t>;

constexpr const char* kTable = "en-ueb-g1.ctb";

Sheet sheet(const std::string& paper = "a4") {
    Sheet sheet;
    sheet.paper = find_paper(paper, "");
    sheet.medium = &find_medium("embosser", "");
    sheet.cell = kMarburgMedium;
    sheet.braille_table = kTable;
    return sheet;
}

std::vector<std::string> words(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::string> made;
    for (std::size_t i = 0; i < count; ++i) {
        std::string word;
        for (std::size_t letters = 1 + random() % 11; letters > 0; --letters) word += static_cast<char>('a' + random() % 26);
        made.push_back(word);
    }
    return made;
}

std::string joined_words(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

// As a hand reads: line by line from the top, cells from the left; nothing is said of the order in which the page holds them.
struct Row {
    std::size_t first = 0;  // cell
    Cells cells;
};
std::vector<Row> rows_of(const Page& page) {
    std::map<long, std::map<long, std::uint8_t>> found;
    for (const BrailleLine& line : page.braille)
        for (std::size_t i = 0; i < line.cells.size(); ++i)
            if (line.cells[i] != 0)
                found[std::lround((line.first_dot.y - page.live.top) / page.cell.line_pitch)]
                     [std::lround((line.first_dot.x - page.live.left) / page.cell.cell_pitch) + static_cast<long>(i)] =
                         line.cells[i];
    std::vector<Row> rows;
    for (const auto& [row, cells] : found) {
        while (static_cast<long>(rows.size()) < row) rows.emplace_back();
        Row& made = rows.emplace_back();
        made.first = static_cast<std::size_t>(cells.begin()->first);
        made.cells.resize(static_cast<std::size_t>(cells.rbegin()->first) + 1, 0);
        for (const auto& [at, cell] : cells) made.cells[static_cast<std::size_t>(at)] = cell;
    }
    return rows;
}

Cells cells_of(const std::string& text) { return to_braille(text, kTable, "test"); }

// All words of the pages without page numbers, separated by single blanks.
Cells read(const std::vector<Page>& pages) {
    Cells all;
    for (const Page& page : pages) {
        const std::vector<Row> rows = rows_of(page);
        for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
            if (!rows[i].cells.empty() && !all.empty()) all.push_back(0);
            all.insert(all.end(),
                       rows[i].cells.begin() + static_cast<std::ptrdiff_t>(std::min(rows[i].first, rows[i].cells.size())),
                       rows[i].cells.end());
        }
    }
    return all;
}

TEST(TextPages, HoldEveryWordOnceAndInOrder) {
    for (unsigned seed = 1; seed < 6; ++seed)
        for (const char* paper : {"a4", "a5", "11x11.5"}) {
            std::vector<TextBlock> blocks;
            Cells all;
            for (unsigned i = 0; i < 30; ++i) {
                const std::string text = joined_words(words(1 + (seed * 7 + i * 13) % 150, seed * 100 + i));
                blocks.push_back({i % 9 == 4 && text.size() < 60 ? Kind::heading : Kind::paragraph, text});
                const Cells cells = cells_of(text);
                if (!all.empty()) all.push_back(0);
                all.insert(all.end(), cells.begin(), cells.end());
            }
            const TextPages made = text_pages(blocks, sheet(paper));
            EXPECT_EQ(read(made.pages), all) << paper << seed;
            EXPECT_TRUE(made.unknown.empty());
            for (const Page& page : made.pages)
                for (const BrailleLine& line : page.braille) {
                    const double right = line.first_dot.x + static_cast<double>(line.cells.size()) * page.cell.cell_pitch;
                    EXPECT_LE(right, page.live.left + page.live.width + page.cell.cell_pitch) << paper;
                    EXPECT_LE(line.first_dot.y + 2 * page.cell.dot_pitch, page.live.top + page.live.height + 1e-6) << paper;
                }
        }
}

TEST(TextPages, ParagraphsBeginInCellThreeAndGoOnInCellOne) {
    const TextPages made = text_pages({{Kind::paragraph, joined_words(words(60, 3))}, {Kind::paragraph, "the end"}}, sheet());
    const std::vector<Row> rows = rows_of(made.pages.front());
    EXPECT_EQ(rows.front().first, 2u);
    for (std::size_t i = 1; i + 3 < rows.size() && !rows[i + 1].cells.empty() && rows[i + 1].first == 0; ++i)
        EXPECT_EQ(rows[i].first, 0u) << i;
    std::size_t begun = 0;
    for (const Row& row : rows) begun += !row.cells.empty() && row.first == 2;
    EXPECT_EQ(begun, 2u);
}

TEST(TextPages, HaveTheirNumbersAtTheEndOfTheirLastLine) {
    const TextPages made = text_pages({{Kind::paragraph, joined_words(words(2000, 4))}}, sheet());
    ASSERT_GT(made.pages.size(), 2u);
    std::size_t last = 0, width = 0;
    for (std::size_t i = 0; i < made.pages.size(); ++i) {
        const std::vector<Row> rows = rows_of(made.pages[i]);
        const Row& number = rows.back();
        EXPECT_EQ(Cells(number.cells.begin() + static_cast<std::ptrdiff_t>(number.first), number.cells.end()),
                  cells_of(std::to_string(i + 1)));
        if (i > 0) {
            EXPECT_EQ(rows.size(), last);
            EXPECT_EQ(number.cells.size(), width);
        }
        last = rows.size();
        width = number.cells.size();
    }
}

TEST(TextPages, AHeadingNeverEndsAPage) {
    for (std::size_t before = 0; before < 60; ++before) {
        std::vector<TextBlock> blocks;
        for (std::size_t i = 0; i < before; ++i) blocks.push_back({Kind::paragraph, "line"});
        blocks.push_back({Kind::heading, "heading"});
        blocks.push_back({Kind::paragraph, "behind it"});
        const TextPages made = text_pages(blocks, sheet());
        const Cells heading = cells_of("heading"), next = cells_of("behind it");
        for (const Page& page : made.pages) {
            const std::vector<Row> rows = rows_of(page);
            for (std::size_t i = 0; i < rows.size(); ++i) {
                if (rows[i].first < 4 ||
                    Cells(rows[i].cells.begin() + static_cast<std::ptrdiff_t>(rows[i].first), rows[i].cells.end()) != heading)
                    continue;
                if (i > 0) {
                    EXPECT_TRUE(rows[i - 1].cells.empty()) << before;
                }
                EXPECT_TRUE(rows.at(i + 1).cells.empty()) << before;
                EXPECT_EQ(rows.at(i + 2).cells.size(), next.size() + 2) << before;
            }
        }
    }
}

TEST(TextPages, LettersWithoutCellsAreToldAndNothingElseIsLost) {
    const TextPages made = text_pages({{Kind::paragraph, "one \U0001F600 two x\U0001F600y"}}, sheet());
    ASSERT_EQ(made.unknown, std::vector<std::string>{"\U0001F600"});
    EXPECT_NE(note_of_unknown(made.unknown).english().find("\U0001F600"), std::string::npos);
    const Cells all = read(made.pages);
    const auto holds = [&](const Cells& part) {
        return std::search(all.begin(), all.end(), part.begin(), part.end()) != all.end();
    };
    EXPECT_TRUE(holds(cells_of("one")));
    EXPECT_TRUE(holds(cells_of("two")));
    EXPECT_EQ(std::count(all.begin(), all.end(), 0x3F), 2);
}

TEST(TextPages, WhatStandsBesideALetterWithoutCellsIsSetAsAWhole) {
    const auto all = [](const std::string& text) { return read(text_pages({{Kind::paragraph, text}}, sheet()).pages); };
    Cells expected = cells_of("x12");
    expected.push_back(0x3F);
    const Cells behind = cells_of("CAB");
    expected.insert(expected.end(), behind.begin(), behind.end());
    EXPECT_EQ(all("x12\U0001F600CAB"), expected);
    EXPECT_EQ(all("o\uFB03ce \uFB01rst \uFB05op"), cells_of("office first stop"));
    EXPECT_EQ(all("a\u200Db\u200Cc \uFEFFd\u2060e\u200B"), cells_of("abc de"));
}

TEST(TextPages, RaisedNumbersFollowASignWhereTheTableHasNone) {
    Sheet computer = sheet();
    computer.braille_table = "en-us-comp6.ctb";
    const TextPages made = text_pages({{Kind::paragraph, "x\u00B2 and 10\u207B\u00B9\u2076"}}, computer);
    EXPECT_TRUE(made.unknown.empty());
    EXPECT_EQ(read(made.pages), to_braille("x^2 and 10^-16", "en-us-comp6.ctb", "test"));
    EXPECT_EQ(read(text_pages({{Kind::paragraph, "x\u00B2"}}, sheet()).pages), cells_of("x\u00B2"));
}

TEST(TextPages, RememberAHundredUnknownLettersOfMany) {
    std::string text;
    for (char32_t letter = 0xE400; letter < 0xE400 + 3000; ++letter) {
        append_letter(text, letter);
        text += ' ';
    }
    const TextPages made = text_pages({{Kind::paragraph, text}}, sheet());
    EXPECT_EQ(made.unknown.size(), 100u);
    EXPECT_NE(note_of_unknown(made.unknown).english().find("or more others"), std::string::npos);
    const Cells all = read(made.pages);
    EXPECT_EQ(std::count(all.begin(), all.end(), 0x3F), 3000);
}

TEST(TextPages, AWordLongerThanALineIsCutWithHyphens) {
    const Cells hyphen = cells_of("-"), blank = {0};
    for (std::size_t letters : {20u, 40u, 41u, 42u, 43u, 44u, 45u, 100u, 1000u, 5000u}) {
        const std::string word(letters, 'n');
        for (const std::string before : {"", "and then "}) {
            const TextPages made = text_pages({{Kind::paragraph, before + word + " end"}}, sheet());
            Cells all;
            for (const Page& page : made.pages) {
                const std::vector<Row> rows = rows_of(page);
                for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
                    if (rows[i].cells.empty()) continue;
                    Cells own(rows[i].cells.begin() + static_cast<std::ptrdiff_t>(rows[i].first), rows[i].cells.end());
                    const bool cut = own.size() > hyphen.size() && std::equal(hyphen.rbegin(), hyphen.rend(), own.rbegin());
                    if (cut) own.resize(own.size() - hyphen.size());
                    all.insert(all.end(), own.begin(), own.end());
                    if (!cut) all.push_back(0);
                    EXPECT_LE(rows[i].cells.size(), 45u);
                }
            }
            Cells expected = cells_of(before + word + " end");
            expected.push_back(0);
            EXPECT_EQ(all, expected) << letters << before;
        }
    }
}

TEST(TextPages, MayGoOnWithTheNumbersOfOthers) {
    const TextPages made = text_pages({{Kind::paragraph, joined_words(words(800, 4))}}, sheet(), 41);
    ASSERT_GT(made.pages.size(), 1u);
    for (std::size_t i = 0; i < made.pages.size(); ++i) {
        const Row number = rows_of(made.pages[i]).back();
        EXPECT_EQ(Cells(number.cells.begin() + static_cast<std::ptrdiff_t>(number.first), number.cells.end()),
                  cells_of(std::to_string(41 + i)));
    }
}

TEST(TextPages, SayWhatLeavesNoRoom) {
    Sheet small = sheet();
    small.paper = {"", "", 40, 40};
    EXPECT_THROW(text_pages({{Kind::paragraph, "text"}}, small), Error);
    Sheet none = sheet();
    none.braille_table.clear();
    EXPECT_THROW(text_pages({{Kind::paragraph, "text"}}, none), Error);
    Sheet wrong = sheet();
    wrong.braille_table = "no-such.ctb";
    EXPECT_THROW(text_pages({{Kind::paragraph, "text"}}, wrong), Error);
}

}  // namespace
}  // namespace tactics::text_pages_test
