// SPDX-License-Identifier: Apache-2.0
// Text that is to be read as text: pages of braille, as books have it.
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
    std::vector<Page> pages;  ///< at least one, all of one size
    std::vector<std::string>
        unknown;  ///< the first 100 letters that the table has no cells for; a full cell stands in their place
};

/// Paragraphs begin in cell 3 and go on in cell 1, headings stand in the middle between empty lines and never end a page, each
/// page has its number at the end of its last line (BANA, Braille Formats 2016, sections 1.9, 1.11 and 4.4). A word that
/// is longer than a line is cut with the table's hyphen. The title of the sheet is at the top of the first page, whose number is
/// `number`. Throws Error(usage): no braille table, a title or a margin that leaves no room, paper for less than 10 cells or 3
/// lines; Error(failed): over 20,000 pages.
TextPages text_pages(const std::vector<TextBlock>& blocks, const Sheet& sheet, std::size_t number = 1);

/// Lines of braille on them, the number of each page aside.
std::size_t lines_of_braille(const std::vector<Page>& pages);

/// What is to be told of letters without cells; empty: all have some.
Phrase note_of_unknown(const std::vector<std::string>& letters);

}  // namespace tactics
