// SPDX-License-Identifier: Apache-2.0
#include "cli/report/say.h"

#include <gtest/gtest.h>

#include "cli/report/report.h"

namespace tactics::say_test {
namespace {

TEST(Say, OneLineStaysOneLine) { EXPECT_EQ(one_line("a\n\x1b[1m\tb\x7f\xc3\xa9"), "a\\x0a\\x1b[1m\\x09b\\x7f\xc3\xa9"); }

// U+009B is ESC [ to a terminal, as the bare byte is where it reads Latin-1; the rest ends a line or turns it round.
TEST(Say, NothingOfANameSteersATerminal) {
    EXPECT_EQ(one_line("\xc2\x9b"
                       "2J"),
              "\\xc2\\x9b2J");
    EXPECT_EQ(one_line("\x9b"
                       "2J\xff"),
              "\\x9b2J\\xff");
    EXPECT_EQ(one_line("a\xe2\x80\xae"
                       "gpj\xe2\x80\xa8"
                       "b"),
              "a\\xe2\\x80\\xaegpj\\xe2\\x80\\xa8"
              "b");
    EXPECT_EQ(one_line("\xe2\x9d\xa4\xef\xb8\x8f"), "\xe2\x9d\xa4\xef\xb8\x8f");
}

TEST(Report, ProgressTellsWhatIsLeft) {
    EXPECT_EQ(progress_line(0, 200, 3).english(), "0 of 200 done");
    EXPECT_EQ(progress_line(50, 200, 13.3).english(), "50 of 200 done, about 40 s left");
    EXPECT_EQ(progress_line(199, 200, 4).english(), "199 of 200 done, about 1 s left");
    EXPECT_EQ(progress_line(10, 200, 60).english(), "10 of 200 done, about 19 minutes left");
    EXPECT_EQ(progress_line(200, 200, 60).english(), "200 of 200 done");
}

}  // namespace
}  // namespace tactics::say_test
