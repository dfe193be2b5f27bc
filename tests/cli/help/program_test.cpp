// SPDX-License-Identifier: Apache-2.0
// The lists, the help, the man page and the completion scripts, as the real program gives them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "cli/command.h"
#include "cli/help/catalogue.h"
#include "cli/help/describe.h"
#include "cli/help/thing_texts.h"
#include "filters/list.h"
#include "tests/cli/fake_disk.h"
#include "tests/cli/tool.h"
#include "tests/patterns.h"

namespace tactics::program_test {
namespace {

using namespace tests;

std::size_t lines_in(const std::string& text) { return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')); }

TEST(Program, ToldNothingOrNonsenseSaysWhatToDo) {
    const Folder folder;
    const Ending nothing = run_tactics(folder, {});
    EXPECT_EQ(nothing.code, 1);
    EXPECT_EQ(lines_in(nothing.err), 1u);
    EXPECT_TRUE(holds(nothing.err, "tactics convert photo.jpg -o photo.pdf"));
    EXPECT_EQ(run_tactics(folder, {"convrt"}).err, "tactics: there is no command convrt (convert?); see tactics --help\n");
    EXPECT_EQ(run_tactics(folder, {"photo.jpg"}).err,
              "tactics: there is no command photo.jpg; to make a page from a picture: tactics convert photo.jpg -o page.pdf\n");
    EXPECT_EQ(run_tactics(folder, {"a\nb\x1b"}).err, "tactics: there is no command a\\x0ab\\x1b; see tactics --help\n");
}

TEST(Program, TellsItsVersion) {
    const Folder folder;
    const Ending ending = run_tactics(folder, {"--version"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_TRUE(ending.out.starts_with("tactics ") && lines_in(ending.out) == 1) << ending.out;
    EXPECT_EQ(ending.err, "");
}

TEST(Program, EveryCommandHasHelpInTwoPlaces) {
    const Folder folder;
    const std::string all = run_tactics(folder, {"--help"}).out;
    EXPECT_EQ(run_tactics(folder, {"help"}).out, all);
    for (const Command* command : commands()) {
        EXPECT_TRUE(holds(all, "  " + std::string(command->name) + ": " + std::string(command->summary) + "\n"));
        const Ending help = run_tactics(folder, {std::string(command->name), "--help"});
        EXPECT_EQ(help.code, 0);
        EXPECT_EQ(help.out, run_tactics(folder, {"help", std::string(command->name)}).out);
        for (const Flag& flag : command->flags) EXPECT_TRUE(holds(help.out, "  " + spelling(flag) + ": ")) << flag.name;
        EXPECT_FALSE(command->details.empty() || command->example.empty() || command->run == nullptr) << command->name;
    }
}

TEST(Program, EveryFlagDescribesItself) {
    for (const Command* command : commands()) {
        for (const Flag& flag : command->flags) {
            EXPECT_TRUE(flag.name.starts_with("--") && flag.name.size() > 2) << flag.name;
            EXPECT_TRUE(flag.letter.empty() || (flag.letter.size() == 2 && flag.letter[0] == '-')) << flag.name;
            EXPECT_FALSE(flag.summary.empty()) << flag.name;
            EXPECT_FALSE(flag.summary.ends_with('.')) << flag.name;
            for (const Flag& other : command->flags)
                EXPECT_TRUE(&flag == &other || (flag.name != other.name && (flag.letter.empty() || flag.letter != other.letter)))
                    << flag.name;
        }
    }
}

TEST(Program, EveryEntryOfEveryListHasASummaryAndHelp) {
    const Folder folder;
    const std::string everything = run_tactics(folder, {"list"}).out;
    for (const Group& group : groups()) {
        const auto entries = group.entries();
        EXPECT_FALSE(entries.empty()) << group.name;
        const std::string listed = run_tactics(folder, {"list", std::string(group.name)}).out;
        EXPECT_EQ(lines_in(listed), entries.size()) << group.name;
        for (const Entry& entry : entries) {
            const std::string line = std::string(entry.name) + ": " + std::string(entry.summary) + entry.tail + "\n";
            EXPECT_FALSE(entry.summary.empty()) << entry.name;
            EXPECT_FALSE((!group.installed && entry.summary.ends_with('.')) || holds(std::string(entry.summary), "\n"))
                << entry.name;
            EXPECT_TRUE(holds(listed, line) && holds(everything, "  " + line)) << entry.name;
            EXPECT_TRUE(holds(describe_topic(entry.name), entry.summary)) << entry.name;
        }
    }
    EXPECT_EQ(run_tactics(folder, {"list", "filtres"}).err,
              "tactics: list: there is no list \"filtres\" (filters?); see tactics list\n");
    EXPECT_EQ(error_of([] { describe_topic("sobl"); }), "1 there is no help on \"sobl\" (sobel?); see tactics list");
}

// The example lines of `help NAME` must work: the filters' are tried here.
TEST(Program, ExamplesOfFiltersParse) {
    for (const Entry& entry : find_group("filters")->entries()) {
        const std::string help = describe_topic(entry.name);
        const auto from = help.find("--filter \"") + 10;
        const std::string example = help.substr(from, help.find('"', from) - from);
        EXPECT_EQ(error_of([&] { parse_step(example, "help", filters()); }), "no error") << example;
    }
}

TEST(Program, ListsAsJson) {
    if (!has_tool("python3")) GTEST_SKIP() << "python3 is missing";
    const Folder folder;
    const std::string lines = run_tactics(folder, {"list", "--json"}).out;
    std::size_t entries = 0;
    for (const Group& group : groups()) entries += group.entries().size();
    EXPECT_EQ(lines_in(lines), entries);
    write_bytes(folder / "check.py",
                "import sys, json\n"
                "for line in sys.stdin:\n"
                "    entry = json.loads(line)\n"
                "    assert entry['group'] and entry['name'] and entry['summary']\n"
                "    for s in entry.get('settings', []):\n"
                "        if 'choices' in s: assert s['default'] in s['choices'], (entry, s)\n"
                "        elif 'min' in s: assert s['min'] <= s['default'] <= s['max'], (entry, s)\n"
                "        else: assert s['name'] in ('subject', 'leave', 'creator', 'producer', 'date') and s['default'] == '', "
                "(entry, s)\n");
    const Ending python = run_tool(folder, {"python3", "check.py"}, lines);
    EXPECT_EQ(python.code, 0) << python.err;
}

// One long line: words are not divided, so a search finds them.
std::string shown_page(const Folder& folder, const std::string& roff) {
    const Ending warnings = run_tool(folder, {"groff", "-man", "-ww", "-z"}, roff);
    EXPECT_EQ(warnings.code, 0);
    EXPECT_EQ(warnings.err, "");
    return run_tool(folder, {"groff", "-man", "-Tascii", "-P-cbou", "-rLL=2000n", "-rHY=0"}, roff).out;
}

TEST(Manual, IsCleanRoffWithEveryName) {
    if (!has_tool("groff")) GTEST_SKIP() << "groff is missing";
    const Folder folder;
    const std::string text = shown_page(folder, run_tactics(folder, {"help", "--man"}).out);
    for (const Group& group : groups())
        for (const Entry& entry : group.installed ? std::vector<Entry>{} : group.entries()) {
            EXPECT_TRUE(holds(text, entry.name)) << entry.name;
            EXPECT_TRUE(holds(text, entry.summary)) << entry.summary;
        }
}

TEST(Manual, HasAPageForEveryCommand) {
    const Folder folder;
    ASSERT_EQ(run_tactics(folder, {"help", "--man-pages", folder.path().string()}).code, 0);
    EXPECT_EQ(bytes_of(folder / "tactics.1"), run_tactics(folder, {"help", "--man"}).out);
    const bool groff = has_tool("groff"), lexgrog = has_tool("lexgrog");
    for (const Command* command : commands()) {
        const std::string name = "tactics-" + std::string(command->name);
        const std::string roff = bytes_of(folder / (name + ".1"));
        EXPECT_EQ(roff, run_tactics(folder, {"help", "--man", std::string(command->name)}).out);
        EXPECT_TRUE(holds(bytes_of(folder / "tactics.1"), "tactics\\-" + std::string(command->name) + "\\fP(1)")) << name;
        if (lexgrog) {  // as man -k and apropos have it
            EXPECT_TRUE(holds(run_tool(folder, {"lexgrog", name + ".1"}).out, name + " - " + std::string(command->summary)))
                << name;
        }
        if (!groff) continue;
        const std::string text = shown_page(folder, roff);
        for (const Flag& flag : command->flags) EXPECT_TRUE(holds(text, flag.summary)) << name << ": " << flag.summary;
        EXPECT_TRUE(holds(text, command->example.substr(0, command->example.find('\n')))) << name;
        const bool strict =
            std::any_of(command->flags.begin(), command->flags.end(), [](const Flag& f) { return f.name == "--strict"; });
        EXPECT_EQ(holds(text, "a hard rule broken"), strict) << name;
    }
    EXPECT_EQ(run_tactics(folder, {"help", "--man", "sobel"}).code, 1) << "a filter has none";
    EXPECT_EQ(run_tactics(folder, {"help", "--man-pages", "missing"}).code, 2);
}

// What bash offers after those words.
std::string bash_offers(const std::string& words) {
    const Folder folder;
    write_bytes(folder / "picture.jpg", "");
    write_bytes(folder / "try",
                "source <(\"$1\" completion bash)\n"
                "COMP_WORDS=(" +
                    words + "); COMP_CWORD=$((${#COMP_WORDS[@]}-1))\n_tactics\necho \"${COMPREPLY[*]}\"\n");
    return run_tool(folder, {"bash", "try", TACTICS_PROGRAM}).out;
}

TEST(Completion, OffersWhatIsKnownInBash) {
    if (!has_tool("bash")) GTEST_SKIP() << "bash is missing";
    EXPECT_EQ(bash_offers("tactics conv"), "convert\n");
    EXPECT_EQ(bash_offers("tactics convert pic"), "picture.jpg\n");
    EXPECT_EQ(bash_offers("tactics convert --pap"), "--paper\n");
    EXPECT_EQ(bash_offers("tactics convert --medium thermo"), "thermoform\n");
    EXPECT_EQ(bash_offers("tactics convert --set sobel.bl"), "sobel.blur=\n");
    EXPECT_EQ(bash_offers("tactics convert --orientation ''"), "auto portrait landscape\n");
    EXPECT_EQ(bash_offers("tactics list pap"), "papers\n");
    EXPECT_EQ(bash_offers("tactics help inver"), "invert\n");
}

TEST(Completion, OffersWhatIsKnownInFish) {
    if (!has_tool("fish")) GTEST_SKIP() << "fish is missing";
    const Folder folder;
    const auto offers = [&](const std::string& line) {
        return run_tool(folder, {"fish", "--no-config", "-c",
                                 std::string(TACTICS_PROGRAM) + " completion fish | source; complete -C '" + line + "'"})
            .out;
    };
    EXPECT_TRUE(offers("tactics conv").starts_with("convert\t"));
    EXPECT_TRUE(offers("tactics convert --pap").starts_with("--paper\t"));
    EXPECT_TRUE(offers("tactics convert --medium thermo").starts_with("thermoform\t"));
}

TEST(Completion, IsAScriptInEveryShell) {
    const Folder folder;
    for (const std::string shell : {"bash", "zsh", "fish"}) {
        const Ending script = run_tactics(folder, {"completion", shell});
        EXPECT_EQ(script.code, 0);
        if (!has_tool(shell)) continue;
        write_bytes(folder / "script", script.out);
        const Ending checked = run_tool(folder, {shell, "-n", "script"});
        EXPECT_EQ(checked.code, 0) << shell;
        EXPECT_EQ(checked.err, "") << shell;
    }
    EXPECT_EQ(run_tactics(folder, {"completion", "csh"}).code, 1);
}

// An option that no command has is never given, so nobody would notice a mistake in its name.
TEST(Program, OptionsThatAreReadAreDescribed) {
    std::set<std::string> described{std::string(kHelpFlag.name), std::string(kNoDefaultsFlag.name)};
    for (const Command* command : commands())
        for (const Flag& flag : command->flags) described.insert(std::string(flag.name));
    std::size_t found = 0;
    for (const auto& file : std::filesystem::recursive_directory_iterator(TACTICS_SOURCE_DIR "/cli")) {
        if (!file.is_regular_file()) continue;
        for (const tests::Fit& read :
             tests::all_fits(tests::bytes_of(file.path()), R"x(given(?:\.(?:has|value|all)\(|, )"(--[a-z-]+)")x")) {
            ++found;
            EXPECT_TRUE(described.contains(read[1])) << file.path() << ": " << read[1];
        }
    }
    EXPECT_GT(found, 100u);
}

}  // namespace
}  // namespace tactics::program_test
