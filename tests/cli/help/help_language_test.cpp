// SPDX-License-Identifier: Apache-2.0
// The help of each command is in the user's language, and nothing of it in another; what is typed, and man pages, stay as they
// are.
#include "cli/help/help_language.h"

#include <gtest/gtest.h>

#include "cli/help/thing_texts.h"
#include "tests/cli/tool.h"

namespace tactics::help_language_test {
namespace {

using namespace tests;

std::string help_in(const Folder& folder, const std::string& locale, const std::vector<std::string>& words) {
    std::vector<std::string> all{"env", "-u", "LC_ALL", "-u", "LANGUAGE", "-u", "LC_MESSAGES", "LANG=" + locale, TACTICS_PROGRAM};
    all.insert(all.end(), words.begin(), words.end());
    return run_tool(folder, all).out;
}

TEST(HelpLanguage, APageOfHelpIsInOneLanguage) {
    const Folder folder;
    for (const Command* command : commands()) {
        const std::string name(command->name), german = help_in(folder, "de_DE.UTF-8", {name, "--help"}),
                                               french = help_in(folder, "fr_CA.UTF-8", {"help", name});
        EXPECT_NE(german.find("\nOptionen:\n"), std::string::npos) << name;
        EXPECT_NE(french.find("\nOptions\xC2\xA0:\n"), std::string::npos) << name;
        for (const std::string& text : help_texts(*command)) {
            EXPECT_NE(german.find(help_text(text, "de")), std::string::npos) << text;
            EXPECT_NE(french.find(help_text(text, "fr")), std::string::npos) << text;
            EXPECT_EQ(german.find(": " + text + "\n"), std::string::npos) << text;
        }
        for (const Flag& flag : all_flags(*command)) EXPECT_NE(german.find("\n  " + spelling(flag) + ": "), std::string::npos);
        EXPECT_NE(german.find(indent(command->example)), std::string::npos) << name;
        EXPECT_EQ(help_in(folder, "pl_PL.UTF-8", {name, "--help"}), help_in(folder, "C", {name, "--help"})) << "no catalogue";
        EXPECT_EQ(help_in(folder, "de_DE.UTF-8", {"help", "--man", name}), help_in(folder, "C", {"help", "--man", name})) << name;
    }
    EXPECT_NE(help_in(folder, "de_DE.UTF-8", {"--help"}).find("\n  convert: tastbare Seiten aus Bildern machen\n"),
              std::string::npos);
}

// Half a page would be worse than none.
TEST(HelpLanguage, WithoutATranslationOfOneTextAllIsInEnglish) {
    std::vector<std::string> texts = help_texts(*find_command("list"));
    EXPECT_EQ(language_of_help(texts, "de-AT"), "de");
    EXPECT_EQ(language_of_help(texts, "pl"), "en");
    texts.emplace_back("a text that no catalogue has");
    EXPECT_EQ(language_of_help(texts, "de-AT"), "en");
    EXPECT_EQ(help_text(texts.back(), "de"), texts.back());
}

}  // namespace
}  // namespace tactics::help_language_test
