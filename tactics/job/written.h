// SPDX-License-Identifier: Apache-2.0
// Files that are text rather than figures: their paragraphs and headings.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/layout/text_pages.h"
#include "tactics/readers/read.h"
#include "tactics/readers/svg/pdf_text.h"
#include "tactics/text/phrase.h"

namespace tactics {

struct Written {
    std::vector<TextBlock> blocks;
    std::vector<Phrase> notes;  ///< of what is left out or set on a guess, one line each
};

/// Pages of a PDF, from 1.
struct PageRange {
    int first = 0;  ///< 0: all pages
    int last = 0;   ///< not before the first
};

/// Of a PDF those pages; of any other file its text (written_in_text). What is drawn on pages of a PDF besides letters, and those
/// without a word, are told. Throws Error(failed): it is not UTF-8 text, is a picture or a figure, has more text than
/// kMostTextBytes, or nothing is written in it; Error(usage): there is no such page.
Written text_in(Source& source, PageRange pages);

/// A book of 700,000 words; its braille takes some 8000 pages.
inline constexpr std::size_t kMostTextBytes = 4'000'000;

/// Paragraphs are parted by empty lines; a line of a list, one that is moved in, and a row whose cells are parted by tabs begin
/// by themselves. A line behind one to six # and a blank, and a paragraph of one line with = or - signs below it, are headings.
Written written_in_text(std::string_view text);

/// Whether that page of a PDF is text, as is_text has it.
bool is_page_of_text(const Source& pdf, int page);

/// Whether a page is to be read rather than felt: something is written on it, and either nothing is drawn, or most words stand in
/// lines of many. `drawn`: lines and surfaces besides.
bool is_text(const PdfText& text, std::size_t drawn);

}  // namespace tactics
