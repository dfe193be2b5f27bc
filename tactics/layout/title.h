// SPDX-License-Identifier: Apache-2.0
// The title at the top of a sheet, and the caption below it: print for sighted helpers, then braille.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/layout/sheet.h"
#include "tactics/page.h"

namespace tactics {

/// The title's text and cells, translated once for all orientations of the sheet.
struct Title {
    std::string text;                 ///< one clean line (to_line); empty = none
    std::vector<std::uint8_t> cells;  ///< empty = no braille
    std::string caption = {};         ///< as the title
    std::vector<std::uint8_t> caption_cells = {};
    std::vector<std::uint8_t> hyphen = {};  ///< hyphen_of its table
};
/// Throws Error(usage) as to_braille does, and for a title or a caption that is too long.
Title title_of(const Sheet& sheet);

/// Height of letters above and below the baseline, in em, including accents on capitals (DejaVu Sans).
inline constexpr double kAscent = 0.95;
inline constexpr double kDescent = 0.25;

/// An upper bound of the width of the text in print, in em: layout uses no font, so that the page is the same on a machine that
/// has none.
double print_width(std::string_view text);

/// A line of the title or the caption, which may be broken into several.
bool shows(const PrintLine& line, std::string_view text);

struct TitleBand {
    std::vector<PrintLine> print;
    std::vector<BrailleLine> braille;
    double height = 0;  ///< mm from the top of the live area to the possible top of the drawing; 0 without a title and a caption
};
/// Lines of at most `most` cells, broken at blank cells; a longer word is divided, with `hyphen` after each part except the last.
std::vector<std::vector<std::uint8_t>> wrapped(const std::vector<std::uint8_t>& cells, std::size_t most,
                                               const std::vector<std::uint8_t>& hyphen);

/// The cells of a hyphen in that table; empty: it has no short one, or there is no table.
std::vector<std::uint8_t> hyphen_of(const std::string& braille_table);

/// Its lines are of the words 0, the title, and behind it, if there is one, those of the caption.
TitleBand set_title(const Title& title, const Sheet& sheet, const Rect& live);

}  // namespace tactics
