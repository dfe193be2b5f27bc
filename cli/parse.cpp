// CLI11 sorts the words. The only file that includes it: it takes seconds to compile.
#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/command.h"
#include "tactics/error.h"

namespace tactics {

namespace {

std::vector<Flag> flags_of(const Command& command) {
    std::vector<Flag> flags(command.flags.begin(), command.flags.end());
    flags.push_back(kHelpFlag);
    return flags;
}

const Flag* find_flag(std::span<const Flag> flags, std::string_view name) {
    for (const Flag& flag : flags)
        if (flag.name == name || (!flag.letter.empty() && flag.letter == name)) return &flag;
    return nullptr;
}

// Is the word after it its value? `-o`, `--output`, and the last of several letters: `-qo`.
bool waits_for_value(std::span<const Flag> flags, std::string_view word) {
    if (const Flag* flag = find_flag(flags, word)) return !flag->value.empty();
    if (word.starts_with("--")) return false;
    for (std::size_t i = 1; i < word.size(); ++i) {
        const Flag* flag = find_flag(flags, std::string("-") + word[i]);
        if (flag == nullptr) return false;
        if (!flag->value.empty()) return i + 1 == word.size();
    }
    return false;
}

// Sorts the options with their values from the words, which CLI11 would not leave as they are: to it `[scan]` is a list.
// `--name=value` becomes two words. CLI11 would take the word after `--title=` for the missing value.
std::vector<std::string> separate(std::span<const Flag> flags, const std::vector<std::string>& given,
                                  std::vector<std::string>& words) {
    std::vector<std::string> separated;
    bool only_words = false;  // after "--"
    bool is_value = false;    // it belongs to the option before it, whatever it looks like
    for (const auto& word : given) {
        if (is_value) {
            separated.push_back(word);
            is_value = false;
            continue;
        }
        if (only_words || word.size() < 2 || word[0] != '-') {
            words.push_back(word);
            continue;
        }
        if (word == "--") {
            only_words = true;
            continue;
        }
        const auto equals = word.find('=');
        const Flag* flag =
            word.starts_with("--") && equals != std::string::npos ? find_flag(flags, word.substr(0, equals)) : nullptr;
        if (flag == nullptr) {
            is_value = waits_for_value(flags, word);
            separated.push_back(word);
            continue;
        }
        if (flag->value.empty())
            throw Error(Fault::usage, flag->name, "this option takes no value; leave out " + word.substr(equals));
        separated.push_back(word.substr(0, equals));
        separated.push_back(word.substr(equals + 1));
    }
    return separated;
}

[[noreturn]] void refuse_unknown(const Command& command, std::span<const Flag> flags, const std::string& word) {
    std::vector<std::string_view> names;
    for (const Flag& flag : flags) names.push_back(flag.name);
    const std::string name = word.substr(0, word.find('=')).substr(0, 80);
    throw Error(Fault::usage, "",
                "there is no option " + name + did_you_mean(name, names) + "; see tactics help " + std::string(command.name) +
                    ", and write ./" + name + " for a file of that name");
}

}  // namespace

Given parse_words(const Command& command, const std::vector<std::string>& words) {
    const std::vector<Flag> flags = flags_of(command);
    Given given(command.flags);

    CLI::App app;
    app.set_help_flag();
    app.allow_extras();
    std::vector<std::vector<std::string>> values(flags.size());
    std::vector<CLI::Option*> options;
    for (std::size_t i = 0; i < flags.size(); ++i) {
        const std::string names =
            (flags[i].letter.empty() ? "" : std::string(flags[i].letter) + ",") + std::string(flags[i].name);
        CLI::Option* option = flags[i].value.empty() ? app.add_flag(names) : app.add_option(names, values[i]);
        // One value for each time it is given: `-o a.pdf b.jpg` must leave b.jpg alone.
        if (!flags[i].value.empty()) option->allow_extra_args(false);
        options.push_back(option);
    }

    std::vector<std::string> reversed = separate(flags, words, given.words);
    // What stands where a value is missing can only be the last word.
    const std::string last = reversed.empty() ? "" : reversed.back();
    std::reverse(reversed.begin(), reversed.end());
    try {
        app.parse(reversed);
    } catch (const CLI::ArgumentMismatch&) {
        const Flag* flag = find_flag(flags, last);
        throw Error(Fault::usage, last,
                    flag == nullptr ? "this option cannot stand here; see tactics help " + std::string(command.name)
                                    : "its value is missing; write " + last + " " + std::string(flag->value));
    } catch (const CLI::ParseError& error) {
        throw Error(Fault::usage, command.name, error.what());
    }
    if (const auto unknown = app.remaining(); !unknown.empty()) refuse_unknown(command, flags, unknown.front());

    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (flags[i].value.empty()) {
            if (options[i]->count() > 0) given.add(flags[i].name, "");
            continue;
        }
        if (values[i].size() > 1 && !flags[i].repeatable)
            throw Error(Fault::usage, flags[i].name, "this option is given twice; give it once");
        for (auto& value : values[i]) given.add(flags[i].name, std::move(value));
    }
    return given;
}

}  // namespace tactics
