// SPDX-License-Identifier: Apache-2.0
// Lines of braille: broken between words, and within a word only where it is longer than a line.
#include "tactics/layout/wrapped.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace tactics::wrapped_test {
namespace {

using Cells = std::vector<std::uint8_t>;

constexpr std::uint8_t kHyphen = 0x24;

Cells cells_of(const std::string& text) {
    Cells cells;
    for (const char c : text) cells.push_back(c == ' ' ? 0 : c == '-' ? kHyphen : static_cast<std::uint8_t>(c - 'a' + 1));
    return cells;
}

std::string told(const std::vector<Cells>& lines) {
    std::string text;
    for (const Cells& line : lines) {
        for (const std::uint8_t cell : line) text += cell == 0 ? ' ' : cell == kHyphen ? '-' : static_cast<char>('a' + cell - 1);
        text += '|';
    }
    return text;
}

TEST(Wrapped, ALongWordIsCutWithAHyphen) {
    const auto lines = [](const std::string& text, std::size_t most) {
        return told(wrapped(cells_of(text), most, WordDivision({kHyphen})));
    };
    EXPECT_EQ(lines("abc defg", 8), "abc defg|");
    EXPECT_EQ(lines("abc defg", 7), "abc|defg|");
    EXPECT_EQ(lines("abcdefgh", 5), "abcd-|efgh|");
    EXPECT_EQ(lines("ab cdefghij kl", 5), "ab|cdef-|ghij|kl|");
    EXPECT_EQ(lines("abcdef", 2), "ab|cd|ef|") << "there is no room for a hyphen";
    EXPECT_EQ(told(wrapped(cells_of("abcdefgh"), 5, WordDivision())), "abcde|fgh|") << "a table without one";
}

// Whatever the words: no line is too long, a hyphen stands only behind a part of a word that is longer than a line, and without
// these hyphens the words are what they were.
TEST(Wrapped, LosesNoCell) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 500; ++trial) {
        std::string text;
        for (std::size_t words = 1 + random() % 5; words > 0; --words) {
            for (std::size_t letters = 1 + random() % 12; letters > 0; --letters) text += static_cast<char>('a' + random() % 20);
            text += words > 1 ? " " : "";
        }
        const std::size_t most = 3 + random() % 10;
        std::string again;
        for (const Cells& line : wrapped(cells_of(text), most, WordDivision({kHyphen}))) {
            ASSERT_LE(line.size(), most);
            std::string one = told({line});
            one.pop_back();
            const bool cut = one.ends_with('-');
            EXPECT_TRUE(!cut || one.size() == most) << "it is cut as late as can be";
            again += cut ? one.substr(0, one.size() - 1) : one + " ";
        }
        again.pop_back();
        EXPECT_EQ(again, text) << most;
    }
}

// A hyphen that is put in, to tell it from those of the words.
constexpr std::uint8_t kPutIn = 0x3F;

// Cells of letters, as no contractions hide what is lost; places as the tables' languages have them.
WordDivision division_by(const std::string& table, const std::string& text, std::size_t* translated = nullptr) {
    return {{kPutIn}, text, table, "", [translated](const std::string& part) {
                if (translated != nullptr) *translated += part.size();
                return std::optional(cells_of(part));
            }};
}

std::string hyphened_word(std::mt19937& random, std::size_t parts) {
    constexpr std::array<const char*, 6> kParts{"beamten", "dampfschifffahrt", "a", "gb", "urlaubsantrag", "nord"};
    std::string word;
    for (; parts > 0; --parts) {
        word += kParts[random() % kParts.size()];
        if (parts > 1) word += random() % 9 == 0 ? "--" : random() % 4 == 0 ? "" : "-";
    }
    return word;
}

// With places to divide, too: what was put in taken away, every word is what it was, and none was put in behind a hyphen.
TEST(Wrapped, LosesNoCellOfWordsThatAreDivided) {
    std::mt19937 random(11);
    for (int trial = 0; trial < 400; ++trial) {
        std::string text;
        for (std::size_t words = 1 + random() % 4; words > 0; --words)
            text += hyphened_word(random, 1 + random() % (trial % 10 == 0 ? 60 : 5)) + (words > 1 ? " " : "");
        const std::size_t most = 6 + random() % 30;
        const std::string table = trial % 2 == 0 ? "de-g2.ctb" : "he-IL.utb";  // the second has no patterns
        std::size_t longest = 0, length = 0;  // without a hyphen; the first line has up to 3 cells fewer
        for (const char c : text) longest = std::max(longest, length = c == '-' || c == ' ' ? 0 : length + 1);
        Cells again;
        bool parted = false;
        for (const Cells& line : wrapped(cells_of(text), most, division_by(table, text), random() % 4)) {
            ASSERT_FALSE(line.empty());
            ASSERT_LE(line.size(), most);
            // Behind the end of a line there is a blank, unless the word goes on.
            const bool goes_on = again.size() < text.size() && !again.empty() && text[again.size()] != ' ';
            EXPECT_TRUE(again.empty() || goes_on == (parted || again.back() == kHyphen)) << text;
            if (!again.empty() && !goes_on) again.push_back(0);
            again.insert(again.end(), line.begin(), line.end());
            parted = line.back() == kPutIn;
            if (parted) again.pop_back();
            ASSERT_FALSE(parted && again.back() == kHyphen && most > longest + 4) << text << ' ' << most;
        }
        EXPECT_EQ(told({again}), text + "|") << most;
    }
}

// The naive twin: of all places, the longest part that fits.
TEST(Wrapped, TakesTheLongestPart) {
    std::mt19937 random(5);
    for (int trial = 0; trial < 300; ++trial) {
        std::string word;
        for (std::size_t parts = 3 + random() % 80; parts > 0; --parts) word += std::string(1 + random() % 6, 'b') + "-";
        word += "bb";
        const std::size_t most = 8 + random() % 30;
        std::vector<std::string> expected;
        std::string rest = word;
        while (rest.size() > most) {
            const std::size_t end = rest.rfind('-', most - 1) + 1;
            expected.push_back(rest.substr(0, end));
            rest.erase(0, end);
        }
        expected.push_back(rest);
        std::vector<Cells> cells;
        for (const std::string& line : expected) cells.push_back(cells_of(line));
        EXPECT_EQ(told(wrapped(cells_of(word), most, division_by("he-IL.utb", word))), told(cells)) << most;
    }
}

// A word of many hyphens is translated a few times, however long it is.
TEST(Wrapped, TranslatesALongWordAFewTimes) {
    for (const std::string part : {"aa-", "-", "a-", "abcdefghijklmnopqrst-"}) {
        std::string word;
        while (word.size() < 60'000) word += part;
        std::size_t translated = 0;
        const auto lines = wrapped(cells_of(word), 40, division_by("en-ueb-g1.ctb", word, &translated));
        EXPECT_GE(lines.size(), word.size() / 40);
        EXPECT_LT(translated, word.size() * 20) << part;
    }
}

// In German contracted braille "im" has the cell of the hyphen.
TEST(Wrapped, AsksTheLettersWhetherTheyEndInAHyphen) {
    const WordDivision division({kHyphen}, "beamten", "de-g2.ctb", "", [](const std::string& part) {
        Cells cells = cells_of(part);
        cells.back() = kHyphen;  // whatever the letter is
        return std::optional(cells);
    });
    EXPECT_EQ(told(division.lines_of("beamten", cells_of("beamten"), 5, 5)), "b--|amte-|")
        << "two letters, the second a contraction";
}

}  // namespace
}  // namespace tactics::wrapped_test
