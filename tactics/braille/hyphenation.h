// SPDX-License-Identifier: Apache-2.0
// Where words may be divided at the end of a line, by the hyphenation patterns that come with liblouis (F. M. Liang, "Word
// hy-phen- a-tion by com-put-er", 1983).
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace tactics {

/// How many bytes of the word stand before each place, ascending: "Beamten" gives 2. The language is that of the braille table
/// (one of liblouis's own, "de-g2.ctb"), else the one of the tag. Capitals count as small letters. A place has at least two
/// letters on each side; behind a hyphen of the word's own is one, too. Empty: it may not be divided, or there are no patterns
/// for the language. Thread-safe.
std::vector<std::size_t> places_to_divide(std::string_view word, std::string_view braille_table, std::string_view language);

/// The last letter of the part is a hyphen of its own: "-", U+2010 or a dash between words (U+2013).
bool ends_in_hyphen(std::string_view part);

}  // namespace tactics
