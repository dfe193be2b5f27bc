// SPDX-License-Identifier: Apache-2.0
// Text to braille cells, through liblouis.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/error.h"

namespace tactics {

/// Cells of `utf8` in a liblouis table ("en-ueb-g2.ctb"): bit 0 = dot 1 ... bit 7 = dot 8. Thread-safe. A name is that of a table
/// which liblouis brought with it; a path, or another name of a file, is a table of the user's own, which is read by a program
/// that is shut in, in 10 seconds and 512 MiB. Throws Error(usage) at the wish "braille": unknown or harmful table, even for an
/// empty text; at `text_place`, where the text came from: too long, invalid UTF-8, a letter that the table has no cells for (the
/// first is named).
std::vector<std::uint8_t> to_braille(std::string_view utf8, std::string_view table,
                                     std::string_view text_place = spelled("title"));

/// The tables of text that liblouis brought with it, by name, in the order of the alphabet.
std::vector<std::string> braille_tables();

/// The BRF letter of a 6-dot cell (North American Braille Computer Code): 64 characters from 20h to 5Fh.
char brf_letter(std::uint8_t cell);

}  // namespace tactics
