// SPDX-License-Identifier: Apache-2.0
// What a command (a verb of the command line) says of itself. One thin file each, one line each in list.inc.
// Parsing, help, completion and the man page all read these descriptions.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tactics {

/// An option of a command.
struct Flag {
    std::string_view name = {};    ///< "--output"
    std::string_view letter = {};  ///< "-o", or empty
    std::string_view value = {};   ///< what follows it, for the help: "FILE"; empty: it is a switch
    std::string_view summary = {};
    bool repeatable = false;
    /// What shell completion offers for the value, separated by one space: "files", "folders", the name of a group of
    /// `tactics list`, "settings" (all NAME.OPTION), "limits" (all RULE.LIMIT), or a word to type. Empty: nothing.
    std::string_view offers = {};
    /// A name by which some call it, too, understood and not shown; where a command has an option of that name, it is that one.
    std::string_view also = {};
};

/// A choice that is kept for all jobs (kept_choices.h).
struct KeptValue {
    std::string value;
    std::string place;  ///< where it stands, for messages: "/etc/xdg/tactics/defaults:3"
};

/// What the user gave: values by option, and the words that belong to no option. What is kept is apart from it: it counts where
/// the user gave nothing, and gives way where it does not fit.
class Given {
public:
    explicit Given(std::span<const Flag> flags);

    bool has(std::string_view name) const { return !all(name).empty(); }
    /// The value, or `fallback`.
    std::string value(std::string_view name, std::string_view fallback = "") const;
    /// All values in order; one empty text for each time a switch was given. None of an option that the command does not have:
    /// what several commands share asks for more than each of them offers.
    const std::vector<std::string>& all(std::string_view name) const;
    void add(std::string_view name, std::string value);

    /// What is kept by that word ("paper"), unless the option of that name was given; nullptr: nothing.
    const KeptValue* kept(std::string_view word) const;
    void keep(std::string_view word, KeptValue kept);

    std::vector<std::string> words;

private:
    std::vector<std::pair<std::string_view, std::vector<std::string>>> values_;
    std::vector<std::pair<std::string, KeptValue>> kept_;
};

struct Command {
    std::string_view name = {};
    std::string_view summary = {};  ///< one line, lower case, no period
    std::string_view words = {};    ///< what it takes besides options, for the help: "INPUT... -o OUT"
    std::string_view details = {};  ///< paragraphs of plain text, separated by an empty line
    std::string_view example = {};  ///< lines to type
    std::span<const Flag> flags = {};
    std::string_view offers = {};              ///< what completion offers for the words, as in Flag
    bool takes_kept = false;                   ///< choices that are kept count for it
    int (*run)(const Given& given) = nullptr;  ///< gives the exit code
};

std::span<const Command* const> commands();
const Command* find_command(std::string_view name);  ///< nullptr if there is none

/// Every command has it besides its own.
inline constexpr Flag kHelpFlag{"--help", "-h", "", "show the help of this command", false, ""};

/// Commands that take what is kept have it besides.
inline constexpr Flag kNoDefaultsFlag{
    "--no-defaults", "", "", "ignore the choices that tactics defaults shows, and the recipes kept beside them: for scripts",
    false,           ""};

/// All options of a command, those that are not its own last.
std::vector<Flag> all_flags(const Command& command);

/// Sorts the words of a command line. Throws Error(usage) with the nearest option.
Given parse_words(const Command& command, const std::vector<std::string>& words);

/// The whole program: parses, runs, prints errors. Gives the exit code.
int run_program(int count, char** words);

}  // namespace tactics
