// SPDX-License-Identifier: Apache-2.0
// A braille display of one line or several, as Unicode text of exactly its cells: each page is all that it shows at a time.
#include <algorithm>

#include "print/format.h"
#include "print/text_job.h"

namespace tactics {

namespace {

constexpr Option kBrailleDisplayOptions[] = {
    {.name = "columns",
     .type = Option::Type::whole,
     .fallback = 40,
     .min = 4,
     .max = 1000,
     .unit = "cells",
     .summary = "number of cells in a line"},
    {.name = "lines", .type = Option::Type::whole, .fallback = 10, .min = 1, .max = 1000, .summary = "lines of cells"},
    {.name = "dots",
     .type = Option::Type::choice,
     .fallback = 1,
     .min = 0,
     .max = 1,
     .summary = "dots per cell; with 8, rows of dots are assumed to be evenly spaced, within lines and from line to line",
     .choices = "6 8"},
};

// Each cell in the middle of its room.
DotSetting braille_display_dots(const Settings& settings) {
    const CellSize cell = kMarburgMedium;
    const int down = settings.choice("dots") == "8" ? 4 : 3;
    const Point first{(cell.cell_pitch - cell.dot_pitch) / 2, (cell.line_pitch - (down - 1) * cell.dot_pitch) / 2};
    return {cell, {first, 0, down}, settings.whole("columns") * cell.cell_pitch, settings.whole("lines") * cell.line_pitch};
}

std::string encode_pages_braille_display(std::span<const Page> pages, const Settings& settings) {
    const auto columns = static_cast<std::size_t>(settings.whole("columns")),
               lines = static_cast<std::size_t>(settings.whole("lines"));
    std::string text;
    for (const Page& page : pages) {
        if (!text.empty()) text += '\f';
        const std::vector<std::uint8_t> cells = cells_of(page, columns, lines);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            text += unicode_letter(cells[i]);
            if ((i + 1) % columns == 0) text += '\n';
        }
    }
    return text;
}

}  // namespace

extern const Format braille_display_format;
const Format braille_display_format{
    .name = "braille-display",
    .summary = "Unicode braille text in the size of a braille display, to which show sends it",
    .medium = "embosser",
    .paper = "a5",
    .options = kBrailleDisplayOptions,
    .encode_pages = encode_pages_braille_display,
    .dots = braille_display_dots,
};

}  // namespace tactics
