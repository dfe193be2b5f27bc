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

/// The title's text and cells, translated once for every way of turning the sheet.
struct Title {
    std::string text;                 ///< one clean line (to_line); empty = none
    std::vector<std::uint8_t> cells;  ///< empty = no braille
    std::string caption = {};         ///< as the title
    std::vector<std::uint8_t> caption_cells = {};
    std::vector<std::uint8_t> hyphen = {};  ///< hyphen_of its table
};
/// Throws Error(usage) as to_braille does, and for a title or a caption too long to be one.
Title title_of(const Sheet& sheet);

/// Room of the letters above and below the baseline in em, accents on capitals included (DejaVu Sans).
inline constexpr double kAscent = 0.95;
inline constexpr double kDescent = 0.25;

/// At least as wide, in em, as the text is in print: the page is laid out without a font, so that it is the same page on a
/// machine that has none.
double print_width(std::string_view text);

/// A line of the title or the caption, which may have been cut.
bool shows(const PrintLine& line, std::string_view text);

struct TitleBand {
    std::vector<PrintLine> print;
    std::vector<BrailleLine> braille;
    double height = 0;  ///< mm from the top of the live area to where the drawing may begin; 0 without a title and a caption
};
/// Lines of at most `most` cells, broken at blank cells; a longer word is cut, with `hyphen` behind each of its parts but the
/// last.
std::vector<std::vector<std::uint8_t>> wrapped(const std::vector<std::uint8_t>& cells, std::size_t most,
                                               const std::vector<std::uint8_t>& hyphen);

/// The cells of a hyphen in that table; empty: it has none that is short, or there is no table.
std::vector<std::uint8_t> hyphen_of(const std::string& braille_table);

/// Its lines are of the words 0, the title, and behind it, if there is one, those of the caption.
TitleBand set_title(const Title& title, const Sheet& sheet, const Rect& live);

}  // namespace tactics
