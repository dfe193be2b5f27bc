// SPDX-License-Identifier: Apache-2.0
// The table of all rules: what each asks for, who says so and how sure that is, a page that just passes and one that just
// fails. With TACTICS_RULES_TABLE=FOLDER in the environment it is written there: rules.md, and the pages as SVG.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "print/format.h"
#include "tactics/units.h"
#include "tests/rules/pages.h"
#include "tests/rules/rule_pages.h"

namespace tactics::rules_table_test {
namespace {

using namespace tests;

// "at least 3.2 mm; thermoform 4 mm, embosser 2.5 mm"
std::string limit_words(const Rule& rule) {
    const std::string unit = rule.limit.unit.empty() ? "" : " " + std::string(rule.limit.unit);
    std::string words = rule.limit.name == "least" ? "at least " : "at most ", others;
    words += to_text(rule.limit.fallback) + unit;
    for (const Medium& medium : media()) {
        const auto limit = limit_of(rule, medium);
        if (limit && *limit == rule.limit.fallback) continue;
        others += (others.empty() ? "; " : ", ") + std::string(medium.name) + " " + (limit ? to_text(*limit) + unit : "none");
    }
    return words + others;
}

struct Example {
    std::string file;
    Page page;
};

// The limit of swell paper, or of the first medium that the rule is about.
std::pair<Example, Example> examples_of(const Rule& rule) {
    std::optional<double> limit;
    for (const Medium& medium : media())
        if (!limit) limit = limit_of(rule, medium);
    const bool least = rule.limit.name == "least";
    const double step = rule.limit.type == Option::Type::whole ? 1 : std::min(*limit == 0 ? 0.1 : *limit / 20, 0.5);
    const PageOf& page = rule_pages().at(std::string(rule.name));
    const std::string name(rule.name);
    return {{name + "-passes.svg", page(step == 1 ? *limit : *limit + (least ? step : -step))},
            {name + "-fails.svg", page(*limit + (least ? -step : step))}};
}

std::string table() {
    std::string text =
        "| rule | what | limit | confidence | must | source | just passes | just fails |\n|---|---|---|---|---|---|---|---|\n";
    for (const Rule* rule : rules()) {
        const auto [passes, fails] = examples_of(*rule);
        text += "| " + std::string(rule->name) + " | " + std::string(rule->summary) + " | " + limit_words(*rule) + " | " +
                std::string(name_of(rule->confidence)) + " | " + (rule->hard ? "yes" : "a person looks") + " | " +
                std::string(rule->source) + " | [" + passes.file + "](" + passes.file + ") | [" + fails.file + "](" + fails.file +
                ") |\n";
    }
    return text;
}

TEST(RulesTable, HasARowForEveryRule) {
    const std::string text = table();
    EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), rules().size() + 2);
    EXPECT_NE(text.find("| gap |"), std::string::npos);
    EXPECT_NE(text.find("at least 3.2 mm; thermoform 4 mm, embosser 2.5 mm"), std::string::npos) << text;
    // No bar in our text must be taken for a column border.
    EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '|')), (rules().size() + 2) * 9);

    const char* folder = std::getenv("TACTICS_RULES_TABLE");
    if (folder == nullptr) return;
    std::filesystem::create_directories(folder);
    const auto write = [&](const std::string& name, const std::string& bytes) {
        std::ofstream file(std::filesystem::path(folder) / name, std::ios::binary);
        file << bytes;
        EXPECT_TRUE(file.good()) << name;
    };
    write("rules.md", text);
    const Format& svg = *find_format("svg");
    for (const Rule* rule : rules()) {
        const auto [passes, fails] = examples_of(*rule);
        for (const Example& example : {passes, fails}) write(example.file, svg.encode(example.page, Settings(svg.options)));
    }
}

}  // namespace
}  // namespace tactics::rules_table_test
