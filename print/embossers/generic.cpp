// SPDX-License-Identifier: Apache-2.0
// Any machine that takes braille as text: 6 dots in North American Braille Computer Code, 8 dots as Unicode braille in UTF-8.
//
// It is set up by hand. The settings here describe where it raises dots, so that a drawing keeps its shape: a circle stays round
// at any line distance.
#include "print/embosser.h"
#include "print/format.h"
#include "print/machines/machines.h"
#include "print/text_job.h"

namespace tactics {

namespace {

constexpr Option kGenericOptions[] = {
    {.name = "dots",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "dots of a cell",
     .choices = "6 8"},
    {.name = "line",
     .type = Option::Type::length,
     .fallback = 10,
     .min = 7.5,
     .max = 20,
     .unit = "mm",
     .summary = "distance from line to line; 10 or more with 8 dots"},
    {.name = "cell",
     .type = Option::Type::length,
     .fallback = 6,
     .min = 5,
     .max = 10,
     .unit = "mm",
     .summary = "distance from cell to cell"},
    {.name = "dot",
     .type = Option::Type::length,
     .fallback = 2.5,
     .min = 2,
     .max = 3.3,
     .unit = "mm",
     .summary = "distance from dot to dot"},
    {.name = "left",
     .type = Option::Type::length,
     .fallback = 6.8,
     .min = 0,
     .max = 60,
     .unit = "mm",
     .summary = "distance from the sheet's left edge to its first dot"},
    {.name = "top",
     .type = Option::Type::length,
     .fallback = 6.8,
     .min = 0,
     .max = 60,
     .unit = "mm",
     .summary = "distance from the sheet's top edge to its first dot"},
};

constexpr ProtocolFact kGenericFacts[] = {
    {"each cell is one letter of North American Braille Computer Code (BRF); lines end with CR LF, pages with FF",
     "cups-filters textbrftoindexv3; libembosser unicodeToAscii", Confidence::good},
    {"8 dots are sent as UTF-8 of U+2800 to U+28FF", "cups-filters imagetoubrl, for machines and displays that take it",
     Confidence::uncertain},
};

DotSetting generic_dots(const Settings& settings) {
    const bool eight = settings.choice("dots") == "8";
    CellSize cell;
    cell.dot_pitch = settings.number("dot");
    cell.cell_pitch = settings.number("cell");
    cell.line_pitch = settings.number("line");
    return {cell, DotBed{{settings.number("left"), settings.number("top")}, 0, eight ? 4 : 3}};
}

std::string encode_pages_generic(std::span<const Page> pages, const Settings& settings) {
    TextJob job;
    job.letter = settings.choice("dots") == "8" ? unicode_letter : nabcc_letter;
    return text_job(pages, job);
}

constexpr Embosser kGenericEmbosser{
    .models = "any machine that takes BRF or Unicode braille",
    .punch = punch_generic,
    .facts = kGenericFacts,
};

}  // namespace

extern const Format generic_format;
const Format generic_format{
    .name = "generic",
    .summary = "any embosser that takes braille as text; set its distances between dots, cells and lines",
    .medium = "embosser",
    .paper = "11x11.5",
    .options = kGenericOptions,
    .encode_pages = encode_pages_generic,
    .embosser = &kGenericEmbosser,
    .dots = generic_dots,
};

}  // namespace tactics
