// SPDX-License-Identifier: Apache-2.0
// What studies say of themselves, as the help and the checks of evaluate read it.
#include "studies/list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "cli/command.h"
#include "filters/list.h"
#include "tests/cli/tool.h"

namespace tactics::list_test {
namespace {

using namespace tests;

TEST(Studies, EachIsFoundByItsName) {
    std::set<std::string_view> names;
    for (const Study* study : studies()) {
        EXPECT_EQ(find_study(study->name), study);
        EXPECT_TRUE(names.insert(study->name).second) << study->name;
        EXPECT_NE(study->run, nullptr) << study->name;
        EXPECT_TRUE(study->details.ends_with(".")) << study->name;
        EXPECT_EQ(study->details.find("\n\n"), std::string_view::npos) << study->name << " has one paragraph";
        if (!study->name.empty()) {
            EXPECT_TRUE(std::islower(static_cast<unsigned char>(study->details[0])) != 0)
                << study->name << " goes on from its name";
        }
    }
    EXPECT_TRUE(names.contains("")) << "what is asked without --study";
    EXPECT_EQ(find_study("nonsense"), nullptr);
}

// What they name is there: recipes, options of evaluate; and no two call an option of theirs the same, or as evaluate calls one.
TEST(Studies, NameWhatThereIs) {
    const Command& evaluate = *find_command("evaluate");
    const auto flags_called = [&](std::string_view name) {
        return std::count_if(evaluate.flags.begin(), evaluate.flags.end(),
                             [&](const Flag& flag) { return flag.name == "--" + std::string(name); });
    };
    for (const Study* study : studies()) {
        for (const auto names : {study->recipes, study->without})
            for (const std::string_view name : names)
                if (name != "auto") {
                    EXPECT_NO_THROW(find_recipe(name, study->name));
                }
        if (!study->besides.empty()) {
            EXPECT_NO_THROW(parse_step(study->besides, study->name, filters()));
        }
        for (const Refusal& refusal : study->refuses) EXPECT_EQ(flags_called(refusal.option), 1) << refusal.option;
        for (const Option& option : study->options) {
            EXPECT_EQ(flags_called(option.name), 1) << option.name;
            EXPECT_EQ(option.type, Option::Type::whole) << option.name;
            EXPECT_FALSE(study->no_options.text.empty() || option.summary.empty()) << option.name;
        }
    }
}

TEST(Studies, AreOfferedAndExplainedAsTheListHasThem) {
    const Folder folder;
    const std::string help = run_tactics(folder, {"help", "evaluate"}).out;
    const Ending unknown = run_tactics(folder, {"evaluate", "set", "--study", "nonsense"});
    EXPECT_EQ(unknown.code, 1);
    const std::vector<std::string_view> names = study_names();
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    for (const std::string_view name : names) {
        EXPECT_TRUE(holds(help, "--study " + std::string(name) + " ")) << name;
        EXPECT_TRUE(holds(unknown.err, name)) << unknown.err;
        for (const std::string shell : {"bash", "zsh", "fish"})
            EXPECT_TRUE(holds(run_tactics(folder, {"completion", shell}).out, name)) << shell << ": " << name;
    }
}

}  // namespace
}  // namespace tactics::list_test
