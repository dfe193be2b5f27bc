// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cli/command.h"
#include "tests/cli/fake_disk.h"

namespace tactics::parse_test {
namespace {

using tests::error_of;
using Words = std::vector<std::string>;

Given convert(const Words& words) { return parse_words(*find_command("convert"), words); }
std::string refused(const Words& words) {
    return error_of([&] { convert(words); });
}

TEST(Parse, TakesOneValueForEachOption) {
    const Given given = convert({"-o", "a.pdf", "b.jpg", "-oc.pdf", "--output=d.pdf", "--output", "-", "list", "-"});
    EXPECT_EQ(given.all("--output"), (Words{"a.pdf", "c.pdf", "d.pdf", "-"}));
    EXPECT_EQ(given.words, (Words{"b.jpg", "list", "-"}));
}

TEST(Parse, AValueMayBeEmptyOrLookLikeAnything) {
    const Given given = convert({"--title=", "a.jpg", "--filter", "sobel blur=0.5mm", "--margin", "-2", "-o", "--json"});
    EXPECT_EQ(given.all("--title"), (Words{""}));
    EXPECT_EQ(given.words, (Words{"a.jpg"}));
    EXPECT_EQ(given.value("--filter"), "sobel blur=0.5mm");
    EXPECT_EQ(given.value("--margin"), "-2");
    EXPECT_EQ(given.value("--output"), "--json");
    EXPECT_FALSE(given.has("--json"));
    EXPECT_EQ(convert({"--title", "--output=x"}).value("--title"), "--output=x");
    EXPECT_EQ(convert({"--title", "[a, b]"}).value("--title"), "[a, b]");
    EXPECT_EQ(convert({"--title=a=b"}).value("--title"), "a=b");
    EXPECT_EQ(convert({""}).words, (Words{""}));
}

TEST(Parse, AfterTwoHyphensAreOnlyWords) {
    EXPECT_EQ(convert({"--json", "--", "-odd.jpg", "--output=x"}).words, (Words{"-odd.jpg", "--output=x"}));
}

TEST(Parse, WordsStayAsTheyAre) {
    const Words words{"[scan]", "[a,b]", "++", "-", "", "a=b", "'c'", "\"d\"", "%%", "{e}"};
    EXPECT_EQ(convert(words).words, words);
    const Given given = convert({"-qo", "[out]", "[in]", "-o", "--", "-o[x]"});
    EXPECT_EQ(given.all("--output"), (Words{"[out]", "--", "[x]"}));
    EXPECT_EQ(given.words, (Words{"[in]"}));
    EXPECT_TRUE(given.has("--quiet"));
}

TEST(Parse, TellsTheNearestOption) {
    EXPECT_EQ(refused({"--papr", "a4"}),
              "1 there is no option --papr (--paper?); see tactics help convert, and write ./--papr for a file of that name");
    EXPECT_EQ(refused({"a.jpg", "--paper"}), "1 --paper: its value is missing; write --paper PAPER");
    EXPECT_EQ(refused({"-o"}), "1 -o: its value is missing; write -o OUT");
    EXPECT_EQ(refused({"--paper", "a4", "--paper", "a3"}), "1 --paper: this option is given twice; give it once");
    EXPECT_EQ(refused({"--json=yes"}), "1 --json: this option takes no value; leave out =yes");
}

}  // namespace
}  // namespace tactics::parse_test
