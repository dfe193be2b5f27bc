// SPDX-License-Identifier: Apache-2.0
// Choices that a person or a machine keeps for all jobs: lines such as "paper a4" in the file `defaults` of the folders of
// config_folders.h.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "tactics/job/kept_sheet.h"

namespace tactics {

/// A word that may stand in such a file.
struct KeptWord {
    std::string_view name;     ///< "paper": that of the option, where there is one
    std::string_view value;    ///< "PAPER", for the help
    std::string_view summary;  ///< what it is for, and what holds where nobody keeps it
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

/// What the text of such a file keeps, in its order. A line is a word and its value, with blanks or an equals sign between them;
/// `#` begins a comment. Throws Error(usage) at `file` and the line: a word that there is not or that stands there twice, a value
/// that it cannot have.
std::vector<KeptChoice> parse_kept(std::string_view text, const std::string& file);

/// That of all files, the most important first: of a word the first counts. Throws Error(usage) as above, Error(failed) for a
/// file that cannot be read.
std::vector<KeptChoice> kept_choices();

/// The person's own file. Throws Error(failed) if the environment names no folder for it.
std::string own_kept_file();

/// What such a file holds; empty if it is not there. Throws Error(failed).
std::string text_of_kept(const std::string& file);

/// `text` with that choice, in the place of an earlier one, else behind all; everything else stays as it is.
std::string with_choice(std::string_view text, std::string_view word, std::string_view value);
/// `text` without any line of that word.
std::string without_choice(std::string_view text, std::string_view word);

/// Throws Error(usage) at `place`: there is no such table of braille, or it cannot be used. It is read for that.
void check_kept_table(const std::string& table, const std::string& place);

/// Gives `given` what is kept, for those of its options that nobody typed.
void take_kept_choices(Given& given);

/// What `given` keeps for sheets.
KeptSheet kept_sheet(const Given& given);

}  // namespace tactics
