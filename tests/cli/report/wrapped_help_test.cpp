// SPDX-License-Identifier: Apache-2.0
#include "cli/report/wrapped_help.h"

#include <gtest/gtest.h>

#include <sstream>

#include "cli/command.h"
#include "cli/help/describe.h"
#include "cli/help/thing_texts.h"
#include "tests/cli/tool.h"

namespace tactics::wrapped_help_test {
namespace {

using namespace tests;

std::vector<std::string> words_in(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

TEST(WrappedHelp, BreaksBetweenWords) {
    EXPECT_EQ(wrapped_help("one two three\n\n  -o, --output OUT: where to\npng: black and white\n", 12),
              "one two\nthree\n\n  -o,\n      --output\n      OUT:\n      where\n      to\npng: black\n    and\n    white\n");
    EXPECT_EQ(wrapped_help("über größe\n", 10), "über größe\n") << "letters count, not bytes";
    EXPECT_EQ(wrapped_help("a\nExample: tactics convert a -o b\n\nExamples:\n  tactics help one two\n\nand on it goes\n", 10),
              "a\nExample: tactics convert a -o b\n\nExamples:\n  tactics help one two\n\nand on it\ngoes\n");
    EXPECT_EQ(wrapped_help("", 10), "");
}

// For any command at any width: the same words in the same order, and no line longer than necessary.
TEST(WrappedHelp, KeepsEveryWord) {
    for (const Command* command : commands()) {
        const std::string text = explain_command(*command);
        for (const std::size_t width : {24u, 40u, 79u}) {
            const std::string wrapped = wrapped_help(text, width);
            EXPECT_EQ(words_in(wrapped), words_in(text)) << command->name;
            std::istringstream lines(wrapped.substr(0, wrapped.find("\nExamples:")));
            for (std::string line; std::getline(lines, line);)
                EXPECT_TRUE(line.size() <= width || words_in(line).size() == 1) << line;
        }
    }
}

TEST(WrappedHelp, OnATerminalOnly) {
    if (!has_tool("script")) GTEST_SKIP() << "script is missing";
    const Folder folder;
    const auto widest = [&](const std::string& line) {
        std::istringstream lines(run_tool(folder, {"script", "-q", "-e", "-c", line, "/dev/null"}).out);
        std::size_t most = 0;
        for (std::string one; std::getline(lines, one) && !one.starts_with("Examples:");) most = std::max(most, one.size());
        return most;
    };
    const std::string program = TACTICS_PROGRAM;
    EXPECT_LE(widest("stty cols 50; env -u COLUMNS " + program + " help convert"), 51u);  // and \r
    EXPECT_LE(widest("stty cols 200; env COLUMNS=60 " + program + " convert --help"), 61u);
    EXPECT_GT(widest("stty cols 200; env COLUMNS=many " + program + " help convert"), 100u);
    EXPECT_EQ(run_tool(folder, {"env", "COLUMNS=40", program, "help", "convert"}).out, explain_command(*find_command("convert")));
}

}  // namespace
}  // namespace tactics::wrapped_help_test
