// SPDX-License-Identifier: Apache-2.0
// Files of text rather than figures: their paragraphs and headings.
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
    std::vector<Phrase> notes;  ///< on things left out or guessed, one line each
};

/// Pages of a PDF, from 1.
struct PageRange {
    int first = 0;  ///< 0: all pages
    int last = 0;   ///< not before the first
};

/// Reads those pages of a PDF, or the text of any other file (written_in_text). Notes report drawings on PDF pages besides
/// letters, and pages without words. Throws Error(failed) if the file is not UTF-8 text, is a picture or a figure, has more text
/// than kMostTextBytes, or has no text; Error(usage) if there is no such page.
Written text_in(Source& source, PageRange pages);

/// A book of 700,000 words, some 8000 pages of braille.
inline constexpr std::size_t kMostTextBytes = 4'000'000;

/// Empty lines separate paragraphs; a list item, an indented line, and a row with tabs between its cells each begin a paragraph.
/// A line after one to six # and a blank, and a one-line paragraph with = or - signs below it, are headings.
Written written_in_text(std::string_view text);

/// Whether that PDF page is text, by is_text.
bool is_page_of_text(const Source& pdf, int page);

/// Whether a page is to be read rather than felt: it has text, and either nothing is drawn, or most words stand in long lines.
/// `drawn`: how many lines and surfaces it has, too; of as many as words, names in one long line each are no text.
bool is_text(const PdfText& text, std::size_t drawn);

}  // namespace tactics
