// SPDX-License-Identifier: Apache-2.0
#include "tactics/braille/hyphenation.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>

#include "tactics/braille/louis.h"
#include "tactics/braille/tables.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr std::size_t kLeastLetters = 2;  // on each side of a division

// "de" of "de-AT" and of "de_DE"
std::string primary(std::string_view tag) { return std::string(tag.substr(0, tag.find_first_of("-_"))); }

// The file of patterns for that language; Norwegian has two, of which Bokmål is the usual one.
std::string patterns_for(const std::string& language) {
    const std::string wanted = "hyph_" + (language == "no" ? "nb" : language);
    std::string found;
    std::error_code unknown;
    for (const auto& entry : std::filesystem::directory_iterator(louis_folder(), unknown)) {
        const std::string name = entry.path().filename().string();
        const bool fits = name.starts_with(wanted) && name.ends_with(".dic") &&
                          (name.size() == wanted.size() + 4 || name[wanted.size()] == '_');
        if (fits && (found.empty() || name < found)) found = name;
    }
    return found;
}

// Patterns, behind a table that knows the letters of the language; empty: there are none.
std::string hyphenation_table(const std::string& language) {
    static std::mutex guard;
    static std::map<std::string, std::string> known;
    const std::lock_guard lock(guard);
    const auto [entry, fresh] = known.try_emplace(language);
    if (!fresh) return entry->second;
    const std::string patterns = patterns_for(language);
    const std::string letters = patterns.empty() ? "" : table_for_tag(language, described_tables());
    if (!letters.empty()) entry->second = letters + "," + patterns;
    return entry->second;
}

std::string language_of(std::string_view braille_table, std::string_view tag) {
    static std::mutex guard;
    static std::map<std::string, std::string, std::less<>> known;
    const std::lock_guard lock(guard);
    const auto before = known.find(braille_table);
    if (before != known.end()) return before->second.empty() ? primary(tag) : before->second;
    std::string language;
    for (const BrailleTable& table : described_tables())
        if (table.name == braille_table) language = primary(table.languages.front());
    known.emplace(braille_table, language);
    return language.empty() ? primary(tag) : language;
}

// Without counting all of a long text.
bool has_letters(std::string_view text, std::size_t least) {
    for (; least > 0 && !text.empty(); --least) take_letter(text);
    return least == 0;
}

}  // namespace

std::vector<std::size_t> places_to_divide(std::string_view word, std::string_view braille_table, std::string_view language) {
    const std::string table = hyphenation_table(language_of(braille_table, language));
    const std::vector<bool> divided = table.empty() ? std::vector<bool>() : divisions_by_louis(word, table);
    std::vector<std::size_t> places;
    std::string_view rest = word;
    for (std::size_t letter = 0; !rest.empty(); ++letter) {
        const std::string_view here = rest;
        const bool may =
            ends_in_hyphen(word.substr(0, word.size() - here.size())) || (letter < divided.size() && divided[letter]);
        if (may && letter >= kLeastLetters && has_letters(here, kLeastLetters)) places.push_back(word.size() - here.size());
        if (take_letter(rest) == kNoLetter) return {};
    }
    return places;
}

bool ends_in_hyphen(std::string_view part) { return part.ends_with('-') || part.ends_with("\u2010") || part.ends_with("\u2013"); }

}  // namespace tactics
