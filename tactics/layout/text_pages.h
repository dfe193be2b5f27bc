// SPDX-License-Identifier: Apache-2.0
// Text to be read as text: braille pages as in books.
#pragma once

#include <string>
#include <vector>

#include "tactics/layout/sheet.h"
#include "tactics/page.h"

namespace tactics {

struct TextBlock {
    enum class Kind { paragraph, heading };
    Kind kind = Kind::paragraph;
    std::string text;  ///< UTF-8, of any length; one line
};

struct TextPages {
    std::vector<Page> pages;           ///< at least one, all of one size
    std::vector<std::string> unknown;  ///< the first 100 letters without cells in the table; a full cell replaces each
};

/// Paragraphs begin in cell 3 and continue in cell 1; headings are centred between empty lines and never end a page; each page
/// has its number at the end of its last line (BANA, Braille Formats 2016, sections 1.9, 1.11 and 4.4). A word longer than a line
/// is divided with the table's hyphen. The title of the sheet is at the top of the first page, whose number is `number`. Throws
/// Error(usage): no braille table, a title or a margin that leaves no room, paper for fewer than 10 cells or 3 lines;
/// Error(failed): over 20,000 pages.
TextPages text_pages(const std::vector<TextBlock>& blocks, const Sheet& sheet, std::size_t number = 1);

/// Number of braille lines on them, without the page numbers.
std::size_t lines_of_braille(const std::vector<Page>& pages);

/// The message about letters without cells; empty: there are none.
Phrase note_of_unknown(const std::vector<std::string>& letters);

}  // namespace tactics
