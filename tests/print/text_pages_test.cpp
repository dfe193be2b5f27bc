// SPDX-License-Identifier: Apache-2.0
// Pages of text between drawings: what each machine makes of them is the text.
#include "print/text_pages.h"

#include <gtest/gtest.h>

#include "print/embosser.h"
#include "tactics/error.h"
#include "tests/cli/tool.h"

namespace tactics::text_pages_test {
namespace {

const Paper kSheet{"", "", 210, 279.4};

std::string text_on(std::string_view name, std::string_view brf, const Paper& paper = kSheet) {
    const Format& format = *find_format(name);
    return text_for(brf, format, Settings(format.options), paper, "story.brf");
}

std::vector<std::string> sheets_of(std::string_view name, const std::string& bytes) {
    const Format& format = *find_format(name);
    const Punched punched = format.embosser->punch(bytes, Settings(format.options));
    EXPECT_TRUE(punched.notes.empty()) << name << ": " << punched.notes[0].english();
    std::vector<std::string> sheets;
    for (const PunchedSheet& sheet : punched.sheets) {
        sheets.emplace_back();
        for (const std::string& line : unicode_of(sheet, 2.5)) sheets.back() += line + "\n";
    }
    return sheets;
}

TEST(TextPages, AreReadByEveryMachineThatSetsText) {
    for (const std::string_view name :
         {"generic", "index-v3", "index-v4", "index-v4-floating", "enabling", "braillo", "cidat", "mountbatten", "nippon"})
        EXPECT_EQ(
            sheets_of(name, text_on(name, "  ,A *ILD\r\n\r\nc&y4\r\n\fEND  \n\f")),
            (std::vector<std::string>{"\u2800\u2800\u2820\u2801\u2800\u2821\u280A\u2807\u2819\n\n\u2809\u282F\u283D\u2832\n",
                                      "\u2811\u281D\u2819\n"}))
            << name;
}

// 10 mm a line, or what the machine has, on 279 mm.
TEST(TextPages, WithoutFormFeedsAPageIsAsLongAsTheSheet) {
    std::string lines;
    for (int i = 0; i < 60; ++i) lines += "A\n";
    EXPECT_EQ(sheets_of("index-v4", text_on("index-v4", lines)).size(), 3u);
    EXPECT_EQ(sheets_of("generic", text_on("generic", lines)).size(), 3u);
    EXPECT_TRUE(tests::holds(text_on("index-v4", lines), "CH33,LP27,LS50,BT0;"));
}

std::string message(std::string_view name, std::string_view brf) {
    try {
        text_on(name, brf);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(TextPages, WhatHasNoRoomIsRefusedWithItsPlace) {
    EXPECT_TRUE(tests::holds(message("index-v4", "A\n\fB\n" + std::string(34, 'C') + "\n"),
                             "story.brf, page 2, line 2: 34 cells are in the line, and the sheet has room for 33"));
    EXPECT_TRUE(tests::holds(message("braillo", std::string(80, 'C')),
                             "; if it is a drawing, convert it for the machine: -o braillo:page.prn"));
    std::string lines = "\f";
    for (int i = 0; i < 28; ++i) lines += "A\n";
    EXPECT_TRUE(tests::holds(message("index-v4", lines), "story.brf, page 2, line 28: 28 lines are on the page"));
    EXPECT_TRUE(tests::holds(message("braillo", "A\x1b\n"), "page 1, line 1: byte 27 is no letter of braille"));
    EXPECT_TRUE(tests::holds(message("viewplus", "A"), "takes pictures only"));
    EXPECT_EQ(message("index-v4", ""), "");
}

// A form feed is one byte, and a page many.
TEST(TextPages, OfMoreThanABookNothingIsKept) {
    const std::string most(20'000, '\f');
    EXPECT_EQ(message("index-v4", "A" + most), "");
    for (const std::string& more : {most + "A", most + "\fA", std::string(5'000'000, '\f'), std::string(5'000'000, '\n')})
        EXPECT_EQ(message("index-v4", more),
                  "story.brf, page 20001, line 1: there are more than 20000 pages; split the file and emboss one part behind the "
                  "other");
}

TEST(TextPages, ControlZAtTheEndIsNotRead) {
    EXPECT_EQ(text_on("generic", "A\r\n\f\x1a\x1a"), text_on("generic", "A\r\n\f"));
    EXPECT_EQ(text_on("generic", "A\x1a"), text_on("generic", "A"));
    EXPECT_TRUE(tests::holds(message("generic",
                                     "A\x1a"
                                     "B"),
                             "page 1, line 1: byte 26 is no letter of braille"));
}

}  // namespace
}  // namespace tactics::text_pages_test
