// SPDX-License-Identifier: Apache-2.0
#include "tactics/braille/foreign_letters.h"

#include <algorithm>

#include "tactics/error.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr std::u32string_view kTakenOver = U"ÀÇÈÉÊÏÑàçèéêïñ";
constexpr std::size_t kMostNamed = 5;

// Latin-1 Supplement, Latin Extended-A and -B, without the signs of multiplication and division; Latin Extended Additional.
bool is_foreign(char32_t letter) {
    const bool latin =
        (letter >= 0xC0 && letter <= 0x24F && letter != 0xD7 && letter != 0xF7) || (letter >= 0x1E00 && letter <= 0x1EFF);
    return latin && kTakenOver.find(letter) == std::u32string_view::npos;
}

}  // namespace

Phrase note_of_foreign_letters(std::string_view title, std::string_view table) {
    if (!table.starts_with("en-") && !table.starts_with("en_")) return {};
    std::u32string found;
    for (std::string_view rest = title; !rest.empty();)
        if (const char32_t letter = take_letter(rest); is_foreign(letter) && found.find(letter) == std::u32string::npos)
            found += letter;
    if (found.empty()) return {};
    std::string letters;
    for (std::size_t i = 0; i < std::min(found.size(), kMostNamed); ++i) {
        letters += i == 0 ? "" : ", ";
        append_letter(letters, found[i]);
    }
    return phrase(
        "the title has {0}, which English does not write, and its braille ({1}) is English; if the title is in another "
        "language, name that: {2} de, for example",
        found.size() > kMostNamed ? phrase("{0} and others", letters) : Phrase(letters), table, spelled("language"));
}

}  // namespace tactics
