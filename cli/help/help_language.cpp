// SPDX-License-Identifier: Apache-2.0
#include "cli/help/help_language.h"

#include <algorithm>

#include "cli/report/user_language.h"
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

std::string_view language_of_help(std::span<const std::string> texts) {
    const std::string_view language = spoken_language(user_language());
    const bool whole =
        std::all_of(texts.begin(), texts.end(), [&](const std::string& text) { return !translated(language, text).empty(); });
    return whole ? language : "en";
}

std::string help_text(std::string_view english, std::string_view language) {
    const std::string_view words = translated(language, english);
    return std::string(words.empty() ? english : words);
}

}  // namespace tactics
