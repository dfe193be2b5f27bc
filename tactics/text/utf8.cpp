// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/utf8.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tactics {

char32_t take_letter(std::string_view& rest) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(rest[i]); };
    const unsigned char first = byte(0);
    // RFC 3629, section 3: how many bytes follow, and the least letter that may be written so.
    constexpr std::size_t kNone = 4;
    std::size_t more = kNone;
    if (first < 0x80)
        more = 0;
    else if (first >= 0xC2 && first < 0xE0)
        more = 1;
    else if (first >= 0xE0 && first < 0xF0)
        more = 2;
    else if (first >= 0xF0 && first < 0xF5)
        more = 3;
    static constexpr std::array<char32_t, 4> kLeast{0, 0x80, 0x800, 0x10000};
    if (more < kNone && rest.size() > more) {
        char32_t letter = more == 0 ? first : first & (0x3Fu >> more);
        std::size_t i = 1;
        while (i <= more && (byte(i) & 0xC0u) == 0x80u) letter = (letter << 6) | (byte(i++) & 0x3Fu);
        const bool surrogate = letter >= 0xD800 && letter < 0xE000;
        if (i > more && letter >= kLeast[more] && letter <= 0x10FFFF && !surrogate) {
            rest.remove_prefix(more + 1);
            return letter;
        }
    }
    rest.remove_prefix(1);
    return kNoLetter;
}

char32_t raised(char32_t sign) {
    if (sign == '1') return 0xB9;
    if (sign == '2' || sign == '3') return 0xB0 + (sign - '0');
    if (is_digit(sign)) return 0x2070 + (sign - '0');
    return sign == '-' || sign == 0x2212 ? 0x207B : 0;
}

char32_t lowered(char32_t sign) {
    if (is_digit(sign)) return 0x2080 + (sign - '0');
    return sign == '-' || sign == 0x2212 ? 0x208B : 0;
}

namespace {

void append_off_line(std::string& text, std::u32string_view letters, char32_t (*small)(char32_t), char mark) {
    const bool all = std::all_of(letters.begin(), letters.end(), [&](char32_t letter) { return small(letter) != 0; });
    if (!all) text += mark;
    for (const char32_t letter : letters) append_letter(text, all ? small(letter) : letter);
}

}  // namespace

void append_raised(std::string& text, std::u32string_view letters) { append_off_line(text, letters, raised, '^'); }
void append_lowered(std::string& text, std::u32string_view letters) { append_off_line(text, letters, lowered, '_'); }

std::size_t letters_in(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

void append_letter(std::string& text, char32_t letter) {
    const auto put = [&](char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (letter < 0x80) {
        put(letter);
    } else if (letter < 0x800) {
        put(0xC0 | (letter >> 6));
        put(0x80 | (letter & 0x3F));
    } else if (letter < 0x10000) {
        put(0xE0 | (letter >> 12));
        put(0x80 | ((letter >> 6) & 0x3F));
        put(0x80 | (letter & 0x3F));
    } else {
        put(0xF0 | (letter >> 18));
        put(0x80 | ((letter >> 12) & 0x3F));
        put(0x80 | ((letter >> 6) & 0x3F));
        put(0x80 | (letter & 0x3F));
    }
}

namespace {

bool is_blank(char32_t letter) {
    return letter == ' ' || (letter >= 0x09 && letter <= 0x0D) || letter == 0x85 || letter == 0xA0 || letter == 0x2028 ||
           letter == 0x2029;
}

// Controls, soft hyphens and blanks without width, marks that turn the direction of writing, selectors of another shape,
// and code points that are no letters (XML allows none of the last).
bool is_unseen(char32_t letter) {
    const auto within = [letter](char32_t first, char32_t last) { return letter >= first && letter <= last; };
    return letter < 0x20 || within(0x7F, 0x9F) || letter == 0xAD || letter == 0x200B || within(0x200E, 0x200F) ||
           within(0x202A, 0x202E) || letter == 0x2060 || within(0x2066, 0x2069) || within(0xFE00, 0xFE0F) || letter == 0xFEFF ||
           (letter & 0xFFFE) == 0xFFFE || within(0xFDD0, 0xFDEF);
}

}  // namespace

bool steers(char32_t letter) {
    const auto within = [letter](char32_t first, char32_t last) { return letter >= first && letter <= last; };
    return letter < 0x20 || within(0x7F, 0x9F) || within(0x200E, 0x200F) || within(0x2028, 0x202E) || within(0x2066, 0x2069) ||
           letter == kNoLetter;
}

std::string to_line(std::string_view text) {
    std::string line;
    bool broken = false;
    while (!text.empty()) {
        const char32_t letter = take_letter(text);
        const bool was_broken = broken;
        broken = letter == kNoLetter;
        if (broken) {
            if (!was_broken) line += '?';
        } else if (is_blank(letter)) {
            if (!line.empty() && line.back() != ' ') line += ' ';
        } else if (!is_unseen(letter)) {
            append_letter(line, letter);
        }
    }
    if (!line.empty() && line.back() == ' ') line.pop_back();
    return line;
}

bool runs_from_right(std::string_view text) {
    // Blocks of the Unicode Standard that hold letters of the classes R and AL.
    constexpr std::pair<char32_t, char32_t> kBlocks[] = {
        {0x0590, 0x08FF}, {0xFB1D, 0xFDFF}, {0xFE70, 0xFEFE}, {0x10800, 0x10FFF}, {0x1E800, 0x1EFFF}};
    while (!text.empty()) {
        const char32_t letter = take_letter(text);
        for (const auto& [first, last] : kBlocks)
            if (letter >= first && letter <= last) return true;
    }
    return false;
}

std::string beginning_of(std::string text) {
    std::size_t end = 80;
    if (text.size() <= end) return text;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    return text.substr(0, end) + "...";
}

}  // namespace tactics
