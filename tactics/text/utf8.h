// SPDX-License-Identifier: Apache-2.0
// Letters of UTF-8 text, with nothing in it that a page or a file format could trip over.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tactics {

/// Takes the first letter off `rest` (not empty). A byte that begins no valid UTF-8 sequence is taken alone and gives
/// kNoLetter, so that every text can be walked to its end.
char32_t take_letter(std::string_view& rest);
inline constexpr char32_t kNoLetter = 0xFFFFFFFF;

/// What a terminal or a log would obey and not show: control characters (of ISO 6429's second set, too: 0x9B is ESC [), ends of
/// lines, and marks that turn the direction of writing. kNoLetter is one, for it may be read as Latin-1.
bool steers(char32_t letter);

/// Some letter of Hebrew, Arabic or another script that is written from right to left.
bool runs_from_right(std::string_view text);

void append_letter(std::string& text, char32_t letter);

/// One of 0 to 9, also for a byte of UTF-8.
constexpr bool is_digit(char32_t letter) { return letter >= '0' && letter <= '9'; }

/// A hyphen, a dash, a minus sign or a tilde: what readers of print take for one another.
constexpr bool is_dash(char32_t letter) {
    return letter == '-' || letter == '~' || (letter >= 0x2010 && letter <= 0x2015) || letter == 0x2212;
}

/// How many letters a UTF-8 text has.
std::size_t letters_in(std::string_view text);

/// Text for one line: valid UTF-8, nothing that is not seen (control characters, marks of direction or shape); blanks and
/// line ends become single spaces, none at the ends; each run of bytes that is not UTF-8 becomes one question mark.
std::string to_line(std::string_view text);

/// What a message says of it: all, or its first 80 bytes (less for a whole letter) and "...".
std::string beginning_of(std::string text);

}  // namespace tactics
