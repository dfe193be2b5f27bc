// SPDX-License-Identifier: Apache-2.0
// Text to braille cells, through liblouis.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/error.h"

namespace tactics {

/// Cells of `utf8` in a liblouis table ("en-ueb-g2.ctb"): bit 0 = dot 1 ... bit 7 = dot 8. Thread-safe. A plain name means one of
/// liblouis's own tables; a path, or another file name, is a table of the user's own, which an isolated program reads, within 10
/// seconds and 512 MiB. Throws Error(usage) at the wish "braille" for an unknown or harmful table, even for an empty text; at
/// `text_place`, the origin of the text, if it is too long, is invalid UTF-8, or has a letter without cells in the table (the
/// first is named).
std::vector<std::uint8_t> to_braille(std::string_view utf8, std::string_view table,
                                     std::string_view text_place = spelled("title"));

/// The names of liblouis's own text tables, in alphabetical order.
std::vector<std::string> braille_tables();

/// The BRF letter of a 6-dot cell (North American Braille Computer Code): 64 characters from 20h to 5Fh.
char brf_letter(std::uint8_t cell);

}  // namespace tactics
