// SPDX-License-Identifier: Apache-2.0
// Lines of braille: broken between words, and within a word only where it is longer than a line.
#include "tactics/layout/wrapped.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace tactics {
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

}  // namespace
}  // namespace tactics
