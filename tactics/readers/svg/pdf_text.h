// SPDX-License-Identifier: Apache-2.0
// What is written on a page of a PDF, as pdftotext tells it, and the same as texts of the page's SVG, in whose place pdftocairo
// has drawn letters.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/page.h"

namespace tactics {

/// Lengths in points (1/72 in) from the upper left corner of the page.
struct PdfWord {
    std::string text;  ///< UTF-8
    Rect box;
};

/// Words that stand on one line, as they are read.
struct PdfLine {
    std::vector<PdfWord> words;
    bool upwards = false, downwards = false;  ///< they run so
};

/// Lines of one paragraph or column.
struct PdfBlock {
    std::vector<PdfLine> lines;
};

struct PdfText {
    double width = 0, height = 0;  ///< of the page
    std::vector<PdfBlock> blocks;  ///< in reading order

    std::size_t count() const;  ///< words
};

/// Of the first page in what `pdftotext -bbox-layout` writes. Throws Error(failed), naming the file: it is something else.
PdfText pdf_text_of(std::string_view bbox_layout, const std::string& file);

/// Parts words of a few letters that stand apart in what `pdftotext -raw -bbox` writes of the same page: of "9 V" and "A B C",
/// whose gaps are all alike, the layout makes one word. Throws as pdf_text_of does.
void part_words(PdfText& text, std::string_view raw_bbox, const std::string& file);

/// The SVG of `pdftocairo -svg` with the words as <text>, each line or piece of a line by itself, exponents and indices as
/// <tspan>; the letters that it drew for them are gone. Letters that no word stands for stay as they are drawn.
std::string with_words(std::string_view svg, const PdfText& text);

}  // namespace tactics
