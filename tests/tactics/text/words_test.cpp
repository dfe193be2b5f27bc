// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/words.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace tactics::words_test {
namespace {

// Every text of up to six letters, as a stream of the library parts it.
TEST(Words, AreThoseOfAStream) {
    constexpr std::string_view kLetters = "a= \t\r";
    for (int code = 0; code < 5 * 5 * 5 * 5 * 5 * 5; ++code) {
        std::string text;
        for (int rest = code; rest > 0; rest /= 5) text += kLetters[static_cast<std::size_t>(rest % 5)];
        std::istringstream stream(text);
        std::vector<std::string> expected;
        for (std::string word; stream >> word;) expected.push_back(word);
        const auto words = words_of(text);
        ASSERT_EQ(std::vector<std::string>(words.begin(), words.end()), expected) << code;
    }
}

TEST(Words, AreJoinedAsASentenceHasThem) {
    EXPECT_EQ(joined({}, ", ", " and "), "");
    EXPECT_EQ(joined({"a"}, ", ", " and "), "a");
    EXPECT_EQ(joined({"a", "b"}, ", ", " and "), "a and b");
    EXPECT_EQ(joined({"a", "b", "c"}, ", ", " and "), "a, b and c");
}

}  // namespace
}  // namespace tactics::words_test
