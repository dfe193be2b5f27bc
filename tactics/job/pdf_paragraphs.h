// SPDX-License-Identifier: Apache-2.0
// What is written on pages of a PDF as paragraphs and headings, from where its words stand and how large they are.
#pragma once

#include <string>
#include <vector>

#include "tactics/layout/text_pages.h"
#include "tactics/readers/svg/pdf_text.h"
#include "tactics/text/parted_words.h"

namespace tactics {

/// Of most words on these pages, in points; 0: nothing is written.
double usual_height(const std::vector<PdfText>& pages);

/// Paragraphs, and headings of at most three lines, which have larger letters than `usual`. `parted` was shown every line of the
/// text (show_lines).
std::vector<TextBlock> paragraphs_of(const PdfText& page, double usual, PartedWords& parted);

/// The same of several pages. A word that is parted at the end of a paragraph or of a page is put together. Where over a third
/// of all words would be in headings, size says nothing, and none are.
std::vector<TextBlock> paragraphs_of(const std::vector<PdfText>& pages, PartedWords& parted);

/// Its words as they are read: a raised number as "x²", other signs as "e^(n+1)", an index as "CO2" or "x_(i)".
std::string words_of(const PdfLine& line);

}  // namespace tactics
