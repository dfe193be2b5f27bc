// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/named_unit.h"

#include <algorithm>

#include "tactics/text/words.h"

namespace tactics {

namespace {

// Of what is written like kg·m/s^2 between other signs.
std::size_t longest_word(std::string_view text) {
    std::size_t longest = 0, length = 0;
    for (const char c : text) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        length = letter ? length + 1 : 0;
        longest = std::max(longest, length);
    }
    return longest;
}

}  // namespace

NamedUnit name_and_unit(std::string_view text) {
    constexpr std::size_t kLongestWord = 6;  // "counts"; "counted" is a word
    text = trimmed(text);
    for (const auto& [open, close] : {std::pair{'(', ')'}, std::pair{'[', ']'}}) {
        if (!text.ends_with(close)) continue;
        const auto at = text.rfind(open);
        if (at == std::string_view::npos || at == 0) continue;
        return {trimmed(text.substr(0, at)), trimmed(text.substr(at + 1, text.size() - at - 2))};
    }
    const auto comma = text.rfind(',');
    if (comma == std::string_view::npos || comma == 0) return {text, {}};
    const std::string_view unit = trimmed(text.substr(comma + 1));
    if (unit.empty() || unit.find(' ') != std::string_view::npos || longest_word(unit) > kLongestWord) return {text, {}};
    return {trimmed(text.substr(0, comma)), unit};
}

}  // namespace tactics
