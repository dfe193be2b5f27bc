// SPDX-License-Identifier: Apache-2.0
// Files that are text rather than figures: their paragraphs and headings.
#pragma once

#include <vector>

#include "tactics/layout/text_pages.h"
#include "tactics/readers/read.h"
#include "tactics/readers/svg/pdf_text.h"

namespace tactics {

/// Of a PDF that page, from 1, or all for 0; of any other file its text. There paragraphs are parted by empty lines; a line that
/// begins with #, or has = or - signs below it, is a heading. Throws Error(failed): it is not UTF-8 text, has over 64 MB, or
/// nothing is written in it.
std::vector<TextBlock> text_in(Source& source, int page);

/// Paragraphs of a page, and its headings, which have larger letters than most of it: `usual` is the height of those. Words that
/// are parted at the end of a line are put together.
std::vector<TextBlock> paragraphs_of(const PdfText& text, double usual);
/// Of most letters, in points; 0: nothing is written.
double usual_height(const PdfText& text);

/// Whether that page of a PDF is text, as is_text has it.
bool is_page_of_text(const Source& pdf, int page);

/// Whether a page is to be read rather than felt: something is written on it, and either nothing is drawn, or most words stand in
/// lines of many. `drawn`: lines and surfaces besides.
bool is_text(const PdfText& text, std::size_t drawn);

}  // namespace tactics
