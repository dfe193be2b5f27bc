// SPDX-License-Identifier: Apache-2.0
#include "cli/help/help_language.h"

#include <algorithm>

#include "tactics/text/catalogue.h"

namespace tactics {

std::vector<std::string> help_texts(const Command& command) {
    std::vector<std::string> texts{std::string(command.summary)};
    for (std::string_view rest = command.details; !rest.empty();) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        if (!line.empty()) texts.emplace_back(line);
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    }
    for (const Flag& flag : all_flags(command)) texts.emplace_back(flag.summary);
    return texts;
}

std::string_view language_of_help(std::span<const std::string> texts, std::string_view language) {
    const std::string_view spoken = spoken_language(language);
    const bool whole =
        std::all_of(texts.begin(), texts.end(), [&](const std::string& text) { return !translated(spoken, text).empty(); });
    return whole ? spoken : "en";
}

std::string help_text(std::string_view english, std::string_view language) {
    const std::string_view words = translated(language, english);
    return std::string(words.empty() ? english : words);
}

}  // namespace tactics
