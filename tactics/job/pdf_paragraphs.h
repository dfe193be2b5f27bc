// SPDX-License-Identifier: Apache-2.0
// The text of PDF pages as paragraphs and headings, from the places and sizes of its words.
#pragma once

#include <string>
#include <vector>

#include "tactics/layout/text_pages.h"
#include "tactics/readers/svg/pdf_text.h"
#include "tactics/text/parted_words.h"

namespace tactics {

/// Size of most words on these pages, in points; 0: no text.
double usual_height(const std::vector<PdfText>& pages);

/// Paragraphs, and headings of at most three lines, which have larger letters than `usual`. `parted` must have seen every line of
/// the text (show_lines).
std::vector<TextBlock> paragraphs_of(const PdfText& page, double usual, PartedWords& parted);

/// The same for several pages. A word that is divided at the end of a paragraph or page is joined. If over a third of all words
/// would be in headings, size is meaningless, and there are none.
std::vector<TextBlock> paragraphs_of(const std::vector<PdfText>& pages, PartedWords& parted);

/// The words as they are read: a superscript number as "x²", other superscripts as "e^(n+1)", a subscript as "CO2" or "x_(i)".
std::string words_of(const PdfLine& line);

}  // namespace tactics
