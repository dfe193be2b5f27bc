// SPDX-License-Identifier: Apache-2.0
// Braille as Unicode text: a letter from U+2800 to U+28FF a cell, in UTF-8, LF after a line, form feed after a page. For braille
// displays, editors, and programs that emboss it.
//
// With a pitch a letter is no cell of braille but two by four dots of a picture, all equally far apart: what cups-filters'
// braille drivers take as image/vnd.cups-ubrl (imageubrltoindexv4, indexv4.drv: HWMargins 5 mm) and send on unchanged.
#include "print/equal_dots.h"
#include "print/format.h"
#include "print/text_job.h"

namespace tactics {

namespace {

constexpr Option kUbrlOptions[] = {
    {.name = "dots",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "dots per cell; with 8, rows of dots are evenly spaced, within lines and from line to line. No effect with a "
                "pitch, where every cell has 8",
     .choices = "6 8"},
    {.name = "pitch",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 3,
     .summary = "distance between dots, mm, if all are equally spaced, for lp -o document-format=image/vnd.cups-ubrl; cells: "
                "the spacing of braille",
     .choices = "cells 1.6 2.0 2.5"},
};

DotSetting ubrl_dots(const Settings& settings) {
    if (const std::string_view pitch = settings.choice("pitch"); pitch != "cells") return equal_dots(pitch, {5.8, 5.8});
    return {kMarburgMedium, {{6.8, 6.8}, 0, settings.choice("dots") == "8" ? 4 : 3}};
}

std::string encode_pages_ubrl(std::span<const Page> pages, const Settings&) {
    TextJob job;
    job.line_end = "\n";
    job.page_end = "\n\f";
    job.letter = unicode_letter;
    return text_job(pages, job);
}

}  // namespace

extern const Format ubrl_format;
const Format ubrl_format{
    .name = "ubrl",
    .summary = "Unicode braille text with a drawing of 6-dot or 8-dot cells, for braille displays and editors",
    .extensions = "ubrl",
    .medium = "embosser",
    .paper = "11x11.5",
    .options = kUbrlOptions,
    .encode_pages = encode_pages_ubrl,
    .dots = ubrl_dots,
};

}  // namespace tactics
