// SPDX-License-Identifier: Apache-2.0
// Lines put together again: no letter and no hyphen of the author's is lost.
#include "tactics/text/parted_words.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace tactics::parted_words_test {
namespace {

std::string typed(std::initializer_list<std::string_view> lines) {
    std::string text;
    for (const std::string_view line : lines) join_typed_line(text, line);
    return text;
}

std::string set(std::initializer_list<std::string_view> lines, std::string_view elsewhere = "") {
    PartedWords parted;
    parted.show(elsewhere);
    for (const std::string_view line : lines) parted.show(line);
    std::string text;
    for (const std::string_view line : lines) parted.join(text, line);
    return text;
}

TEST(PartedWords, TypedHyphensStay) {
    EXPECT_EQ(typed({"write an e-", "mail"}), "write an e-mail");
    EXPECT_EQ(typed({"3-", "4 euros"}), "3-4 euros");
    EXPECT_EQ(typed({"with --no-", "sync"}), "with --no-sync");
    EXPECT_EQ(typed({"Alice said -", "yes"}), "Alice said - yes");
    EXPECT_EQ(typed({"pre-", "and post-war"}), "pre- and post-war");
    EXPECT_EQ(typed({"one", "two"}), "one two");
    EXPECT_EQ(typed({"exam\u00AD", "ple"}), "example");
    EXPECT_EQ(typed({"exam\u2010", "ple"}), "example");
    EXPECT_EQ(typed({"Vor\u2010", "und Nachteile"}), "Vor\u2010 und Nachteile");
    EXPECT_EQ(typed({"sculpt\u00AD", "or"}), "sculptor");
}

TEST(PartedWords, HyphensOfASettingProgramGo) {
    EXPECT_EQ(set({"an exam-", "ple"}), "an example");
    EXPECT_EQ(set({"die F\u00E4-", "higkeiten"}), "die F\u00E4higkeiten");
    EXPECT_EQ(set({"\u0441\u043B\u043E-", "\u0432\u043E"}), "\u0441\u043B\u043E\u0432\u043E");  // Russian
    EXPECT_EQ(set({"exam\u00AD", "ple"}), "example");
}

TEST(PartedWords, TheTextItselfShowsHowAWordIsWritten) {
    EXPECT_EQ(set({"the co-", "op"}, "A (co-op)."), "the co-op");
    EXPECT_EQ(set({"the co-", "op"}, "Coop!"), "the coop");
    EXPECT_EQ(set({"a sculpt-", "or"}, "the sculptor,"), "a sculptor");
    // A word that is itself divided is no evidence.
    EXPECT_EQ(set({"Jean-", "Paul"}), "Jean-Paul");
}

TEST(PartedWords, WordsWithHyphensOfTheirOwnKeepThem) {
    EXPECT_EQ(set({"self-", "employed of twenty-", "five"}), "self-employed of twenty-five");
    EXPECT_EQ(set({"mother-", "in-law"}), "mother-in-law");
    EXPECT_EQ(set({"mother-in-", "law"}), "mother-in-law");
    EXPECT_EQ(set({"--no-", "sync"}), "--no-sync");
    EXPECT_EQ(set({"pages 3-", "fold"}), "pages 3-fold");
    EXPECT_EQ(set({"the x-", "axis"}), "the x-axis");
    EXPECT_EQ(set({"Vor-", "und Nachteile"}), "Vor- und Nachteile");
    EXPECT_EQ(set({"he said -", "yes"}), "he said - yes");
    EXPECT_EQ(set({"selfish: self-", "ish"}), "selfish: selfish");
}

TEST(PartedWords, GuessesAreCountedAndTheFirstAreNamed) {
    PartedWords parted;
    std::string text;
    for (const char* line : {"one exam-", "ple", "an-", "other"}) parted.join(text, line);
    EXPECT_EQ(text, "one example another");
    EXPECT_EQ(parted.guesses(), 2u);
    EXPECT_EQ(parted.guessed(), (std::vector<std::string>{"example", "another"}));
    parted.show("seldom");
    text = "sel-";
    parted.join(text, "dom");
    EXPECT_EQ(text, "seldom");
    EXPECT_EQ(parted.guesses(), 2u);
}

}  // namespace
}  // namespace tactics::parted_words_test
