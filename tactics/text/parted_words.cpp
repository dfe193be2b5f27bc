// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/parted_words.h"

#include <algorithm>
#include <array>

#include "tactics/text/utf8.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

constexpr std::string_view kHyphen = "-", kSoft = "\u00AD", kTrue = "\u2010";
constexpr std::size_t kNamed = 5;  // guesses that are remembered

// Before these words, a hyphen stands for a part that follows later: "pre- and post-war".
constexpr std::array<std::string_view, 12> kAnd = {"und", "oder", "bzw", "and", "or", "to", "et", "ou", "y", "o", "i", "e"};
// English numbers and words that keep their hyphen; syllables that follow the latter in words without one are shorter.
constexpr std::array<std::string_view, 8> kTens = {"twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety"};
constexpr std::array<std::string_view, 2> kCompound = {"self", "well"};
constexpr std::size_t kLongSyllable = 4;

template <std::size_t count>
bool is_among(const std::array<std::string_view, count>& list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

bool within(char32_t letter, char32_t first, char32_t last) { return letter >= first && letter <= last; }

// Small letters of Latin, Greek, Cyrillic and Armenian, as the Unicode Standard has them in its blocks.
bool is_small(char32_t c) {
    const bool odd = c % 2 == 1;
    if (within(c, 'a', 'z') || (within(c, 0xDF, 0xFF) && c != 0xF7)) return true;
    if (within(c, 0x100, 0x137) || within(c, 0x14A, 0x177) || within(c, 0x1DE, 0x24F) || within(c, 0x1E00, 0x1EFF)) return odd;
    if (within(c, 0x138, 0x148) || within(c, 0x179, 0x17E) || within(c, 0x1CD, 0x1DC)) return !odd;
    return c == 0x17F || within(c, 0x250, 0x2AF) || c == 0x390 || within(c, 0x3AC, 0x3CE) || within(c, 0x430, 0x45F) ||
           (within(c, 0x460, 0x52F) && odd) || within(c, 0x561, 0x587) || within(c, 0xFB00, 0xFB06);
}

char32_t small_of(char32_t c) {
    const bool latin = within(c, 'A', 'Z') || (within(c, 0xC0, 0xDE) && c != 0xD7);
    if (latin || within(c, 0x391, 0x3A9) || within(c, 0x410, 0x42F)) return c + 0x20;
    if (within(c, 0x400, 0x40F)) return c + 0x50;
    if (within(c, 0x100, 0x17F) && !is_small(c) && is_small(c + 1)) return c + 1;
    return c;
}

// A letter or a digit: no blank, no stop, no quotation mark.
bool is_of_word(char32_t c) {
    if (c < 0x80) return within(c, '0', '9') || within(c, 'a', 'z') || within(c, 'A', 'Z');
    return c >= 0xC0 && c != 0xD7 && c != 0xF7 && !within(c, 0x2000, 0x206F) && c != kNoLetter;
}

char32_t first_letter(std::string_view text) { return text.empty() ? kNoLetter : take_letter(text); }

char32_t last_letter(std::string_view text) {
    auto at = text.size();
    while (at > 0 && (static_cast<unsigned char>(text[--at]) & 0xC0) == 0x80) {
    }
    return first_letter(text.substr(at));
}

// In small letters, without stops and brackets around it.
std::string plain(std::string_view word) {
    std::string out;
    std::size_t end = 0;
    while (!word.empty()) {
        const char32_t letter = take_letter(word);
        if (!is_of_word(letter) && (out.empty() || letter == kNoLetter)) continue;
        append_letter(out, letter == 0x2010 ? U'-' : small_of(letter));
        if (is_of_word(letter)) end = out.size();
    }
    out.resize(end);
    return out;
}

std::string_view hyphen_of(std::string_view text) {
    for (const std::string_view hyphen : {kHyphen, kSoft, kTrue})
        if (text.ends_with(hyphen) && is_of_word(last_letter(text.substr(0, text.size() - hyphen.size())))) return hyphen;
    return {};
}

std::string_view last_word(std::string_view text) { return text.substr(text.find_last_of(" \t") + 1); }
std::string_view first_word(std::string_view line) { return line.substr(0, line.find_first_of(" \t")); }

bool leaves_out(std::string_view hyphen, std::string_view next) { return hyphen != kSoft && is_among(kAnd, plain(next)); }

}  // namespace

bool ends_parted(std::string_view text) { return !hyphen_of(text).empty(); }
bool begins_small(std::string_view text) { return is_small(first_letter(text)); }

void join_typed_line(std::string& text, std::string_view line) {
    const std::string_view hyphen = hyphen_of(text);
    if (hyphen.empty() ? !text.empty() : leaves_out(hyphen, first_word(line)))
        text += ' ';
    else if (hyphen == kSoft || hyphen == kTrue)
        text.resize(text.size() - hyphen.size());
    text += line;
}

void PartedWords::show(std::string_view line) {
    const auto words = words_of(line);
    for (std::size_t i = 0; i < words.size(); ++i)
        if (i + 1 < words.size() || hyphen_of(words[i]).empty()) seen_.insert(plain(words[i]));
}

bool PartedWords::is_parted(std::string_view before, std::string_view next) {
    const std::string first = plain(before), second = plain(next), whole = first + second;
    if (seen_.contains(whole)) return true;
    if (leaves_out(kHyphen, next)) return false;
    if (seen_.contains(first + "-" + second) || !begins_small(next)) return false;
    if (before.find('-') != before.npos || second.find('-') != second.npos) return false;  // "mother-in-law", "--no-sync"
    if (first.size() < 2 || is_among(kTens, first) || (is_among(kCompound, first) && second.size() > kLongSyllable)) return false;
    if (last_letter(before) < 'A') return false;  // a number
    if (guessed_.size() < kNamed && std::find(guessed_.begin(), guessed_.end(), whole) == guessed_.end())
        guessed_.push_back(whole);
    ++guesses_;
    return true;
}

void PartedWords::join(std::string& text, std::string_view line) {
    if (hyphen_of(text) == kHyphen) {
        const std::string_view before = std::string_view(text).substr(0, text.size() - 1), next = first_word(line);
        if (is_parted(last_word(before), next)) {
            text.pop_back();
            text += line;
            return;
        }
    }
    join_typed_line(text, line);
}

}  // namespace tactics
