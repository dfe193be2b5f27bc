// SPDX-License-Identifier: Apache-2.0
#include "tactics/braille/braille.h"

#include <gtest/gtest.h>
#include <liblouis/liblouis.h>

#include <cstdlib>
#include <set>
#include <thread>

#include "tactics/error.h"
#include "tactics/page.h"
#include "tests/tactics/braille/message_of.h"

namespace tactics::braille_test {
namespace {

using tests::message_of;

// Cells as Unicode braille patterns, so that a test can be read.
std::string shown(std::string_view text, std::string_view table) {
    std::string line;
    for (const std::uint8_t cell : to_braille(text, table)) {
        line += '\xE2';
        line += static_cast<char>(0xA0 | (cell >> 6));
        line += static_cast<char>(0x80 | (cell & 0x3F));
    }
    return line;
}

constexpr std::string_view kGrade1 = "en-ueb-g1.ctb";
constexpr std::string_view kGrade2 = "en-ueb-g2.ctb";

TEST(Braille, UnifiedEnglish) {
    // Rules of Unified English Braille 2013: capital sign dot 6, numeric sign dots 3456, contractions in grade 2.
    EXPECT_EQ(shown("Hot air balloon, 12 m", kGrade1), "⠠⠓⠕⠞⠀⠁⠊⠗⠀⠃⠁⠇⠇⠕⠕⠝⠂⠀⠼⠁⠃⠀⠍");
    EXPECT_EQ(shown("Hot air balloon, 12 m", kGrade2), "⠠⠓⠕⠞⠀⠁⠊⠗⠀⠃⠁⠇⠇⠕⠕⠝⠂⠀⠼⠁⠃⠀⠰⠍");
    EXPECT_EQ(shown("house", kGrade1), "⠓⠕⠥⠎⠑");
    EXPECT_EQ(shown("the people and you", kGrade2), "⠮⠀⠏⠀⠯⠀⠽");
    EXPECT_EQ(shown("NASA", kGrade1), "⠠⠠⠝⠁⠎⠁");
    EXPECT_EQ(shown("2026", kGrade1), "⠼⠃⠚⠃⠋");
    EXPECT_EQ(shown("", kGrade2), "");
}

TEST(Braille, German) {
    // Marburg system: basic braille has one cell for each of sch, au, ei, ss (sharp) and the umlauts.
    EXPECT_EQ(shown("haus", "de-g1.ctb"), "⠓⠡⠎");
    EXPECT_EQ(shown("schön", "de-g1.ctb"), "⠱⠪⠝");
    EXPECT_EQ(shown("straße", "de-g0.utb"), "⠎⠞⠗⠁⠮⠑");
}

// Each table has its own signs for numbers and capitals; nothing of ours is put in front of them.
TEST(Braille, NumbersAndCapitalsAreTheTablesOwn) {
    // UEB: numeric sign 3456, a decimal point and a comma stay within the number, capital 6, word of capitals 6 6.
    for (const std::string_view table : {kGrade1, kGrade2}) {
        EXPECT_EQ(shown("3.5", table), "⠼⠉⠲⠑");
        EXPECT_EQ(shown("1,000", table), "⠼⠁⠂⠚⠚⠚");
        EXPECT_EQ(shown("A4", table), "⠠⠁⠼⠙");
        EXPECT_EQ(shown("3 + 5 = 8", table), "⠼⠉⠀⠐⠖⠀⠼⠑⠀⠐⠶⠀⠼⠓");
    }
    // German: numbers likewise, capitals not told (the system of Marburg and Vienna leaves them out as a rule).
    EXPECT_EQ(shown("Haus 3", "de-g1.ctb"), "⠓⠡⠎⠀⠼⠉");
    EXPECT_EQ(shown("3,5", "de-g1.ctb"), "⠼⠉⠂⠑");
    EXPECT_EQ(shown("Haus 3", "de-g2.ctb"), "⠓⠡⠎⠀⠼⠉");
    // French: digits of Antoine behind dot 6, capital 46.
    EXPECT_EQ(shown("Maison 3", "fr-bfu-comp6.utb"), "⠨⠍⠁⠊⠎⠕⠝⠀⠠⠩");
    EXPECT_EQ(shown("2026", "fr-bfu-comp6.utb"), "⠠⠣⠼⠣⠫");
    EXPECT_EQ(shown("ONU", "fr-bfu-comp6.utb"), "⠨⠨⠕⠝⠥");
}

// liblouis 3.24 has Nemeth for formulae in MathML only; the table for the text around them sets 1,000 and x+1 wrongly.
TEST(Braille, NemethIsRefusedWithAWordOnWhatThereIs) {
    for (const std::string_view name : {"nemeth", "nemeth.ctb", "en-us-nemeth.ctb"})
        EXPECT_NE(message_of("3 + 5", name)
                      .find("liblouis has Nemeth for MathML only, not for plain text; en-ueb-g1.ctb has signs for numbers and "
                            "formulae"),
                  std::string::npos)
            << message_of("3 + 5", name);
}

TEST(Braille, BackTranslationGivesTheTextAgain) {
    const char* const kTexts[] = {"hello world",
                                  "a cat sat on the mat",
                                  "Hot air balloon",
                                  "Map of the United States",
                                  "NASA space shuttle",
                                  "figure 12: growth of a plant",
                                  "the quick brown fox jumps over the lazy dog",
                                  "knowledge, comfort and understanding",
                                  "3.14159",
                                  "What is it? It is a heart!",
                                  "\"Quoted\" (and bracketed)",
                                  "Dr. Neil has 4 houses"};
    for (const std::string_view table : {kGrade1, kGrade2}) {
        for (const std::string text : kTexts) {
            std::vector<widechar> cells;
            for (const std::uint8_t cell : to_braille(text, table)) cells.push_back(0x2800u + cell);
            std::vector<widechar> back(500);
            int in = static_cast<int>(cells.size()), out = static_cast<int>(back.size());
            const std::string list = "unicode.dis," + std::string(table);
            ASSERT_EQ(lou_backTranslateString(list.c_str(), cells.data(), &in, back.data(), &out, nullptr, nullptr, 0), 1);
            std::string read;
            for (int i = 0; i < out; ++i) read += static_cast<char>(back[static_cast<std::size_t>(i)]);
            EXPECT_EQ(read, text) << table;
        }
    }
}

TEST(Braille, SaysWhatIsWrongWithATable) {
    const std::string missing = message_of("a", "en-ueb-g3.ctb");
    EXPECT_EQ(missing.find("--braille: there is no braille table \"en-ueb-g3.ctb\" (en-ueb-g"), 0u) << missing;
    EXPECT_NE(missing.find("see tactics list braille"), std::string::npos) << missing;
    for (const std::string bad : {"", ",", "unicode.dis,", " ", ".", "/", "/usr"})
        EXPECT_EQ(message_of("a", bad).find("--braille: there is no braille table \"" + bad + "\""), 0u) << bad;
    EXPECT_EQ(message_of("a", std::string_view("en-ueb-g2.ctb\0x", 15)).find("--braille: there is no braille table"), 0u);
    EXPECT_EQ(message_of("a", std::string(100'000, 'x')).find("--braille: there is no braille table"), 0u);
    const std::string broken = message_of("a", TACTICS_SOURCE_DIR "/LICENSE");
    EXPECT_NE(broken.find("LICENSE\" is no liblouis table (it does not understand line 2); see tactics list braille"),
              std::string::npos)
        << broken;
    EXPECT_EQ(broken.find("Apache"), std::string::npos) << "what is in the file is not for the terminal: " << broken;
    EXPECT_EQ(shown("still well", kGrade1), "⠎⠞⠊⠇⠇⠀⠺⠑⠇⠇");
}

TEST(Braille, LiblouisNeverWritesToTheTerminal) {
    testing::internal::CaptureStderr();
    message_of("a", "nosuch.ctb");
    message_of("a", TACTICS_SOURCE_DIR "/LICENSE");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Braille, RefusesWhatIsNotUtf8) {
    for (const std::string_view bad : {"\x80", "\xC0\xAF", "\xC3", "\xE2\x82", "\xED\xA0\x80", "\xF4\x90\x80\x80",
                                       "\xF8\x88\x80\x80\x80", "\xE0\x80\xAF", "\xF0\x80\x80\xAF", "caf\xE9"})
        EXPECT_EQ(message_of(bad, kGrade1).find("--title: the text for braille is not UTF-8"), 0u) << bad;
    EXPECT_EQ(message_of("caf\xC3\xA9", kGrade1), "no error");
    EXPECT_EQ(message_of(std::string(20'000, 'a'), kGrade1),
              "--title: the text is too long to be set in braille (over 10000 bytes); shorten it");
}

TEST(Braille, RefusesLettersThatTheTableLacks) {
    const auto refusal = [](std::string_view letter, std::string_view number, std::string_view table) {
        return "--title: braille table \"" + std::string(table) + "\" has no cells for \"" + std::string(letter) + "\" (" +
               std::string(number) + "); name a table that has them with --braille, or leave braille out with --braille none";
    };
    EXPECT_EQ(message_of("cat 日本 the", kGrade2), refusal("日", "U+65E5", kGrade2));
    EXPECT_EQ(message_of("hot air balloon 🎈", kGrade1), refusal("🎈", "U+1F388", kGrade1));
    EXPECT_EQ(message_of("Київ", kGrade2), refusal("К", "U+041A", kGrade2));
    EXPECT_EQ(message_of("Київ", "uk.utb"), "no error");
    EXPECT_EQ(message_of("schön Ω", "de-g1.ctb"), refusal("Ω", "U+03A9", "de-g1.ctb"));
    try {
        to_braille("日", kGrade2, "--title-from-name");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find("--title-from-name: braille table "), 0u) << error.what();
    }
}

// A letter may stand anywhere among others: what is refused is what is refused alone, and the first of them is named.
// Unicode has those of formulas once more for each look.
TEST(Braille, LettersOfFormulasAreLetters) {
    const auto same = [](std::string_view formula, std::string_view plain) {
        EXPECT_EQ(to_braille(formula, kGrade2), to_braille(plain, kGrade2)) << formula;
    };
    same("𝑥 𝐀 ℎ 𝟗", "x A h 9");
    same("𝛼 𝛚 𝜙 𝜖 𝚪 𝛀 𝝅", "α ω φ ε Γ Ω π");
    same("ϕ ϵ ϑ ϱ", "φ ε θ ρ");
    EXPECT_EQ(message_of("𝑥日", kGrade2).find("U+1D465") != std::string::npos, true) << "the text is told as it is";
}

TEST(Braille, RefusesALetterWhereverItStands) {
    const std::string letters[] = {"a", "B", "7", " ", "é", "²", "日", "☃", "-", "the "};
    std::set<std::string> missing;
    for (const std::string& letter : letters)
        if (message_of(letter, kGrade2) != "no error") missing.insert(letter);
    EXPECT_EQ(missing, (std::set<std::string>{"日", "☃"}));
    for (const std::string& a : letters)
        for (const std::string& b : letters)
            for (const std::string& c : letters) {
                const std::string* first = missing.contains(a)   ? &a
                                           : missing.contains(b) ? &b
                                           : missing.contains(c) ? &c
                                                                 : nullptr;
                const std::string said = message_of(a + b + c, kGrade2);
                if (first == nullptr)
                    EXPECT_EQ(said, "no error") << a << b << c;
                else
                    EXPECT_NE(said.find(" has no cells for \"" + *first + "\" "), std::string::npos)
                        << a << b << c << ": " << said;
            }
}

TEST(Braille, WhatIsNotSeenHasNoCell) {
    EXPECT_EQ(to_braille(std::string_view("a\0b\nc", 5), kGrade1), to_braille("ab c", kGrade1));
    EXPECT_EQ(to_braille("\xEF\xBB\xBFhot\xC2\xAD air\xE2\x80\x8B \xE2\x80\x8E", kGrade1), to_braille("hot air", kGrade1));
}

TEST(Braille, LongTextIsSetWhole) {
    // An ellipsis takes three cells, more than there is room for at first.
    std::string text;
    for (int i = 0; i < 1000; ++i) text += "\xE2\x80\xA6";
    EXPECT_EQ(to_braille("\xE2\x80\xA6", kGrade1).size(), 3u);
    EXPECT_EQ(to_braille(text, kGrade1).size(), 3000u);
}

TEST(Braille, SameCellsFromManyThreads) {
    const auto expected = shown("Hot air balloon", kGrade2);
    const auto german = shown("schönes haus", "de-g1.ctb");
    std::vector<int> wrong(4);
    std::vector<std::thread> threads;
    for (int& count : wrong)
        threads.emplace_back([&] {
            for (int i = 0; i < 100; ++i) {
                if (shown("Hot air balloon", kGrade2) != expected) ++count;
                if (shown("schönes haus", "de-g1.ctb") != german) ++count;
                try {
                    to_braille("a", "nosuch.ctb");
                    ++count;
                } catch (const Error&) {
                }
            }
        });
    for (auto& thread : threads) thread.join();
    EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

// ASCII braille, written down from its definition and not from the order of the cells: dots as digits.
std::uint8_t cell_of(const char* dots) {
    unsigned cell = 0;
    for (; *dots != '\0'; ++dots) cell |= 1u << (*dots - '1');
    return static_cast<std::uint8_t>(cell);
}

TEST(BrfLetter, EveryCell) {
    struct Letter {
        char letter;
        const char* dots;
    };
    // The alphabet, digits as letters a-j dropped one row, then the signs of the North American code.
    const Letter kLetters[] = {
        {'A', "1"},     {'B', "12"},   {'C', "14"},    {'D', "145"},   {'E', "15"},    {'F', "124"},   {'G', "1245"},
        {'H', "125"},   {'I', "24"},   {'J', "245"},   {'K', "13"},    {'L', "123"},   {'M', "134"},   {'N', "1345"},
        {'O', "135"},   {'P', "1234"}, {'Q', "12345"}, {'R', "1235"},  {'S', "234"},   {'T', "2345"},  {'U', "136"},
        {'V', "1236"},  {'W', "2456"}, {'X', "1346"},  {'Y', "13456"}, {'Z', "1356"},  {'1', "2"},     {'2', "23"},
        {'3', "25"},    {'4', "256"},  {'5', "26"},    {'6', "235"},   {'7', "2356"},  {'8', "236"},   {'9', "35"},
        {'0', "356"},   {' ', ""},     {'!', "2346"},  {'"', "5"},     {'#', "3456"},  {'$', "1246"},  {'%', "146"},
        {'&', "12346"}, {'\'', "3"},   {'(', "12356"}, {')', "23456"}, {'*', "16"},    {'+', "346"},   {',', "6"},
        {'-', "36"},    {'.', "46"},   {'/', "34"},    {':', "156"},   {';', "56"},    {'<', "126"},   {'=', "123456"},
        {'>', "345"},   {'?', "1456"}, {'@', "4"},     {'[', "246"},   {'\\', "1256"}, {']', "12456"}, {'^', "45"},
        {'_', "456"},
    };
    std::set<char> seen;
    for (const auto& [letter, dots] : kLetters) {
        EXPECT_EQ(brf_letter(cell_of(dots)), letter) << dots;
        EXPECT_EQ(brf_letter(static_cast<std::uint8_t>(cell_of(dots) | 0xC0)), letter) << "dots 7 and 8 are not in the code";
        seen.insert(letter);
    }
    EXPECT_EQ(seen.size(), 64u);
}

TEST(BrfLetter, AgreesWithLiblouis) {
    for (unsigned cell = 0; cell < 64; ++cell) {
        widechar dots = LOU_DOTS | cell, letter = 0;
        ASSERT_EQ(lou_dotsToChar("text_nabcc.dis", &dots, &letter, 1, 0), 1);
        char upper = static_cast<char>(letter);
        // That table shows lower case and the three signs that share a cell with lower-case code.
        if (upper >= 0x60) upper = static_cast<char>(upper - 0x20);
        EXPECT_EQ(brf_letter(static_cast<std::uint8_t>(cell)), upper) << cell;
    }
}

TEST(Cells, DotsStandWhereTheCellPutsThem) {
    const BrailleLine line{{10, 20}, {cell_of("16"), 0, cell_of("2345")}};
    const auto dots = dots_of(line, kMarburgMedium);
    const std::vector<std::pair<double, double>> expected = {{10, 20}, {12.5, 25}, {22, 22.5},
                                                             {22, 25}, {24.5, 20}, {24.5, 22.5}};
    ASSERT_EQ(dots.size(), expected.size());
    for (std::size_t i = 0; i < dots.size(); ++i) {
        EXPECT_DOUBLE_EQ(dots[i].x, expected[i].first);
        EXPECT_DOUBLE_EQ(dots[i].y, expected[i].second);
    }
    const auto eight = dots_of({{0, 0}, {0xC0}}, kMarburgMedium);
    ASSERT_EQ(eight.size(), 2u);
    EXPECT_DOUBLE_EQ(eight[0].y, 7.5);
    EXPECT_DOUBLE_EQ(eight[1].x, 2.5);
}

}  // namespace
}  // namespace tactics::braille_test
