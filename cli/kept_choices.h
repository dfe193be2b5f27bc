// SPDX-License-Identifier: Apache-2.0
// Choices that a user or a machine keeps for all jobs: lines such as "paper a4" in the file `defaults` of the folders of
// config_folders.h.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "tactics/job/kept_sheet.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// A choice that such a file can hold.
struct KeptWord {
    std::string_view name;                                                        ///< "paper": the option's name, if there is one
    std::string_view value;                                                       ///< "PAPER", for the help
    SourceWords summary;                                                          ///< its meaning and its default
    void (*check)(const std::string& value, const std::string& place) = nullptr;  ///< throws Error(usage) at `place`
};

std::span<const KeptWord> kept_words();
/// Throws Error(usage) at `place` with the nearest name.
const KeptWord& find_kept_word(std::string_view name, std::string_view place);

struct KeptChoice {
    const KeptWord* word = nullptr;
    std::string value;
    std::string place;  ///< "~/.config/tactics/defaults:3"
};

/// The choices in the text of such a file, in order. A line is a word and its value, separated by blanks or an equals sign; `#`
/// begins a comment. Throws Error(usage) at `file` and the line for an unknown or repeated word, or an invalid value.
std::vector<KeptChoice> parse_kept(std::string_view text, const std::string& file);

/// The choices of all files, the most important first: for each word, the first one counts. Throws Error(usage) as above,
/// Error(failed) for a file that cannot be read.
std::vector<KeptChoice> kept_choices();

/// The user's own file. Throws Error(failed) if the environment names no folder for it.
std::string own_kept_file();

/// The contents of such a file; empty if it does not exist. Throws Error(failed).
std::string text_of_kept(const std::string& file);

/// `text` with that choice, in place of an earlier one, else at the end; everything else is unchanged.
std::string with_choice(std::string_view text, std::string_view word, std::string_view value);
/// `text` without lines for that word.
std::string without_choice(std::string_view text, std::string_view word);

/// Throws Error(usage) at `place` if there is no such braille table, or it cannot be used. Reads the table to test it.
void check_kept_table(const std::string& table, const std::string& place);

/// Adds the kept choices to `given`, for its options that were not typed.
void take_kept_choices(Given& given);

/// The kept choices in `given` for sheets.
KeptSheet kept_sheet(const Given& given);

}  // namespace tactics
