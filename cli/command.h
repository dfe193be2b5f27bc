// SPDX-License-Identifier: Apache-2.0
// The description of a command of the program. Each has a thin file and a line in list.inc. Parsing, help, completion and the man
// page all read these descriptions.
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
    /// An alternative name, understood but not shown; if a command has an option of that name, the name means that option.
    std::string_view also = {};
};

/// A choice kept for all jobs (kept_choices.h).
struct KeptValue {
    std::string value;
    std::string place;  ///< where it is kept, for messages: "/etc/xdg/tactics/defaults:3"
};

/// The user's input: values by option, and the words that belong to no option. Kept choices are separate: they apply where the
/// user gave nothing, and yield where they do not fit.
class Given {
public:
    explicit Given(std::span<const Flag> flags);

    bool has(std::string_view name) const { return !all(name).empty(); }
    /// The value, or `fallback`.
    std::string value(std::string_view name, std::string_view fallback = "") const;
    /// All values in order; one empty text for each time a switch was given. Empty for an option that the command does not have,
    /// because shared code asks for more options than each command offers.
    const std::vector<std::string>& all(std::string_view name) const;
    void add(std::string_view name, std::string value);

    /// The kept choice for that word ("paper"), unless the option of that name was given; nullptr: none.
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
    std::string_view words = {};    ///< its arguments besides options, for the help: "INPUT... -o OUT"
    std::string_view details = {};  ///< paragraphs of plain text, separated by an empty line
    std::string_view example = {};  ///< lines to type
    std::span<const Flag> flags = {};
    std::string_view offers = {};              ///< what completion offers for its arguments, as in Flag
    bool takes_kept = false;                   ///< it uses kept choices
    int (*run)(const Given& given) = nullptr;  ///< returns the exit code
};

std::span<const Command* const> commands();
const Command* find_command(std::string_view name);  ///< nullptr if there is none

/// Every command has this option besides its own.
inline constexpr Flag kHelpFlag{"--help", "-h", "", "show the help of this command", false, ""};

/// Commands that use kept choices also have this option.
inline constexpr Flag kNoDefaultsFlag{
    "--no-defaults", "", "", "ignore the choices that tactics defaults shows, and the recipes kept beside them: for scripts",
    false,           ""};

/// All options of a command, the common ones last.
std::vector<Flag> all_flags(const Command& command);

/// Parses a command line. Throws Error(usage) with the nearest option.
Given parse_words(const Command& command, const std::vector<std::string>& words);

/// The whole program: parses, runs, prints errors. Returns the exit code.
int run_program(int count, char** words);

}  // namespace tactics
