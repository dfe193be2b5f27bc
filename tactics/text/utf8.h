// SPDX-License-Identifier: Apache-2.0
// Letters of UTF-8 text, cleaned of everything that could disturb a page or a file format.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tactics {

/// Removes the first letter from `rest` (not empty). A byte that begins no valid UTF-8 sequence is removed alone and gives
/// kNoLetter, so that every text can be read to its end.
char32_t take_letter(std::string_view& rest);
inline constexpr char32_t kNoLetter = 0xFFFFFFFF;

/// Characters that a terminal or a log would obey instead of showing: control characters (including ISO 6429's second set: 0x9B
/// is ESC [), line ends, and marks that change the writing direction. kNoLetter counts, because it may be read as Latin-1.
bool steers(char32_t letter);

/// Whether it has a letter of Hebrew, Arabic or another right-to-left script.
bool runs_from_right(std::string_view text);

void append_letter(std::string& text, char32_t letter);

/// Whether it is one of 0 to 9; for letters and for bytes of UTF-8.
constexpr bool is_digit(char32_t letter) { return letter >= '0' && letter <= '9'; }

/// A hyphen, a dash, a minus sign or a tilde: which readers of print confuse.
constexpr bool is_dash(char32_t letter) {
    return letter == '-' || letter == '~' || (letter >= 0x2010 && letter <= 0x2015) || letter == 0x2212;
}

/// That digit or minus sign as an exponent or an index; 0 for other letters.
char32_t raised(char32_t sign);
char32_t lowered(char32_t sign);
/// Appends them as an exponent, or an index: with signs of their own if there is one for each, or after ^ or _.
void append_raised(std::string& text, std::u32string_view letters);
void append_lowered(std::string& text, std::u32string_view letters);

/// The number of letters in a UTF-8 text.
std::size_t letters_in(std::string_view text);

/// Text for one line: valid UTF-8 without invisible characters (control characters, marks of direction or shape); blanks and line
/// ends become single spaces, with none at the ends; each run of invalid bytes becomes one question mark.
std::string to_line(std::string_view text);

/// The text for a message: all of it, or its first 80 bytes (fewer, to end on a whole letter) and "...".
std::string beginning_of(std::string text);

}  // namespace tactics
