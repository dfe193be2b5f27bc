// SPDX-License-Identifier: Apache-2.0
// The help of commands in the user's language. A page of help is in one language: where a catalogue lacks one of its texts, all
// of it is in English.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"

namespace tactics {

/// What a command says of itself, each with a translation of its own (tactics/text/po): its summary, the lines of its details,
/// and the summaries of its options.
std::vector<std::string> help_texts(const Command& command);

/// That of the catalogue for a reader of `language` ("de" for de-AT), if it has all these texts; else "en".
std::string_view language_of_help(std::span<const std::string> texts, std::string_view language);

/// One of these texts in that language.
std::string help_text(std::string_view english, std::string_view language);

}  // namespace tactics
