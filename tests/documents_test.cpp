// SPDX-License-Identifier: Apache-2.0
// What the documents promise is there: files that they lead to, commands and options that they show.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>

#include "tests/cli/tool.h"

namespace tactics::documents_test {
namespace {

using namespace tests;

const std::filesystem::path kTop = TACTICS_SOURCE_DIR;
constexpr std::array kDocuments{"README.md", "CONTRIBUTING.md", "SECURITY.md", "samples/README.md", "tests/bench/RESULTS.md"};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream from(text);
    for (std::string line; std::getline(from, line);) lines.push_back(line);
    return lines;
}

TEST(Documents, TheFirstPageIsOnePage) { EXPECT_LT(lines_of(bytes_of(kTop / "README.md")).size(), 200u); }

TEST(Documents, LinksLeadSomewhere) {
    std::size_t links = 0;
    for (const std::string document : kDocuments) {
        const std::string text = bytes_of(kTop / document);
        ASSERT_FALSE(text.empty()) << document;
        for (auto at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
            std::string link = text.substr(at + 2, text.find(')', at) - at - 2);
            link = link.substr(0, link.find('#'));
            if (link.empty() || link.find("://") != std::string::npos || link.find(' ') != std::string::npos) continue;
            EXPECT_TRUE(std::filesystem::exists((kTop / document).parent_path() / link)) << document << ": " << link;
            ++links;
        }
    }
    EXPECT_GT(links, 15u);
}

// The options of a line of a shell that begins with the program's name.
std::vector<std::string> options_in(const std::string& line) {
    std::vector<std::string> options;
    std::istringstream words(line);
    for (std::string word; words >> word && word != "|" && word != "&&";)
        if (word.starts_with("--") && word.size() > 2) options.push_back(word.substr(0, word.find('=')));
    return options;
}

TEST(Documents, ShowCommandsAndOptionsThatThereAre) {
    const Folder folder;
    std::map<std::string, std::string> help;
    std::size_t shown = 0;
    for (const std::string document : {"README.md", "samples/README.md"}) {
        bool code = false;
        for (const std::string& line : lines_of(bytes_of(kTop / document))) {
            if (line.starts_with("```")) code = !code;
            if (!code || !line.starts_with("tactics ")) continue;
            std::istringstream words(line);
            std::string verb;
            words >> verb >> verb;
            if (help.count(verb) == 0) {
                const Ending said = run_tactics(folder, {"help", verb});
                EXPECT_EQ(said.code, 0) << document << ": " << line;
                help[verb] = said.out;
            }
            for (const std::string& option : options_in(line.substr(line.find(verb)))) {
                EXPECT_TRUE(holds(help[verb], option)) << document << ": " << line << ": " << option;
                ++shown;
            }
        }
    }
    EXPECT_GT(shown, 40u);
}

}  // namespace
}  // namespace tactics::documents_test
