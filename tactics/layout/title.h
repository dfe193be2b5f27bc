// SPDX-License-Identifier: Apache-2.0
// The title at the top of a sheet, and the caption below it: print for sighted helpers, then braille.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/layout/sheet.h"
#include "tactics/layout/wrapped.h"
#include "tactics/page.h"

namespace tactics {

/// The title's text and cells, translated once for all orientations of the sheet.
struct Title {
    std::string text;                 ///< one clean line (to_line); empty = none
    std::vector<std::uint8_t> cells;  ///< empty = no braille
    std::string caption = {};         ///< as the title
    std::vector<std::uint8_t> caption_cells = {};
    WordDivision division = {}, caption_division = {};
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
/// Its lines are of the words 0, the title, and behind it, if there is one, those of the caption.
TitleBand set_title(const Title& title, const Sheet& sheet, const Rect& live);

}  // namespace tactics
