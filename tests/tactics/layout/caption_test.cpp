// SPDX-License-Identifier: Apache-2.0
// The caption: below the title, in braille from cell 7 with runover from cell 5.
#include <gtest/gtest.h>

#include <algorithm>

#include "tactics/braille/braille.h"
#include "tactics/description/description.h"
#include "tactics/error.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/title.h"
#include "tactics/rules/rule.h"

namespace tactics::caption_test {
namespace {

Sheet sheet_with(const std::string& title, const std::string& caption) {
    Sheet sheet;
    sheet.paper = find_paper("a4", "test");
    sheet.medium = &find_medium("swell", "test");
    sheet.title = title;
    sheet.caption = caption;
    return sheet;
}

const Drawing kDrawing{100, 60, {Stroke{{{0, 0}, {100, 0}, {100, 60}, {0, 60}}, true}}, {}, {}};

std::size_t blanks(const std::vector<std::uint8_t>& cells) {
    return static_cast<std::size_t>(std::find_if(cells.begin(), cells.end(), [](std::uint8_t c) { return c != 0; }) -
                                    cells.begin());
}

TEST(Caption, BeginsInCell7AndRunsOverToCell5) {
    const std::string words =
        "The balloon over the town in the early morning, seen from the tower of the church at the river, with the "
        "hills behind it and the sun just rising";
    const Page page = lay_out(kDrawing, sheet_with("Balloon", words));
    ASSERT_GE(page.braille.size(), 4u);
    EXPECT_EQ(blanks(page.braille[0].cells), 0u) << "the title";
    std::vector<std::uint8_t> joined;
    for (std::size_t i = 1; i < page.braille.size(); ++i) {
        const auto& line = page.braille[i];
        EXPECT_EQ(blanks(line.cells), i == 1 ? 6u : 4u);
        EXPECT_EQ(line.first_dot.x, page.braille[0].first_dot.x) << "cells are counted from the margin";
        EXPECT_GT(line.first_dot.y, page.braille[i - 1].first_dot.y + 9.9);
        EXPECT_LE(line.first_dot.x + static_cast<double>(line.cells.size() - 1) * 6 + 2.5 + 0.8,
                  page.live.left + page.live.width + 1e-9);
        if (i > 1) joined.push_back(0);
        joined.insert(joined.end(), line.cells.begin() + static_cast<std::ptrdiff_t>(blanks(line.cells)), line.cells.end());
    }
    EXPECT_EQ(joined, to_braille(words, "en-ueb-g2.ctb")) << "no cell is lost";
    for (const Verdict& verdict : check_page(page, demands_of(find_medium("swell", "test"))))
        EXPECT_TRUE(verdict.findings.places.empty())
            << verdict.demand.rule->name << ": " << verdict.findings.places[0].message.english();
}

TEST(Caption, StandsWithoutATitleToo) {
    const Page page = lay_out(kDrawing, sheet_with("", "Seen from above"));
    ASSERT_EQ(page.braille.size(), 1u);
    EXPECT_EQ(blanks(page.braille[0].cells), 6u);
    ASSERT_EQ(page.print.size(), 1u);
    EXPECT_EQ(page.print[0].text, "Seen from above");
}

TEST(Caption, IsTold) {
    const auto lines = lines_of(describe(lay_out(kDrawing, sheet_with("Balloon", "Seen from above"))));
    EXPECT_NE(std::find(lines.begin(), lines.end(), "Caption: Seen from above."), lines.end());
    EXPECT_TRUE(std::none_of(lines.begin(), lines.end(), [](const std::string& line) {
        return line.starts_with("Words on the page");
    })) << "once is enough";
}

TEST(Caption, ThatIsTooLongIsTold) {
    const auto message = [](const Sheet& sheet) -> std::string {
        try {
            lay_out(kDrawing, sheet);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    };
    std::string words;
    for (int i = 0; i < 200; ++i) words += "words and ";
    EXPECT_TRUE(message(sheet_with("", words)).starts_with("--caption: the caption takes ")) << message(sheet_with("", words));
    EXPECT_TRUE(message(sheet_with("Map", words)).starts_with("--title: the title and the caption take "))
        << message(sheet_with("Map", words));
    EXPECT_EQ(message(sheet_with("", std::string(10'001, 'a'))), "--caption: the caption is over 10000 bytes long; shorten it");
    EXPECT_TRUE(message(sheet_with("", "\xD0\x96\xE2\x82\xBF\xF0\x9F\x8E\x88")).starts_with("--caption: braille table"))
        << "no cells";
}

}  // namespace
}  // namespace tactics::caption_test
