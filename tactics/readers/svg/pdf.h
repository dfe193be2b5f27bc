// SPDX-License-Identifier: Apache-2.0
// Pages of PDF files, through programs of poppler-utils that read them, shut in (transport/cage.h).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/readers/read.h"
#include "tactics/readers/svg/pdf_text.h"

namespace tactics {

/// A page of a PDF file as SVG, from 1, by pdftocairo; 0: its first, and more pages show as further `page` elements. Letters are
/// shapes there. `pdf` has a file on disk behind it, as open_source gives. Throws Error(failed): the program is not installed,
/// cannot read the file, or takes over a minute or 1 GiB.
std::string pdf_as_svg(const Source& pdf, int page = 0);

/// What is written on a page, from 1. Throws as pdf_as_svg, also for a page that there is not (pages_of_pdf).
PdfText pdf_text(const Source& pdf, int page);

/// A page, from 1, as SVG, lines as lines, `text` as texts and pictures as pictures, in points; nothing: a picture covers most of
/// it, or pixels stand for its lines, so it is a picture as a whole. Throws as pdf_text.
std::optional<std::string> pdf_page_as_svg(const Source& pdf, int page, const PdfText& text);

/// What is written on each of the pages from `first`, from 1, to `last`. Throws as pdf_text.
std::vector<PdfText> pdf_texts(const Source& pdf, int first, int last);

/// Whether something besides letters is on each of these pages: lines, surfaces or pixels. Throws as pdf_text.
std::vector<bool> pdf_pages_drawn(const Source& pdf, int first, int last);

/// A page, from 1, as a PNG in colour, 150 dots per inch: no medium shows more. Throws as pdf_text.
std::string pdf_page_as_png(const Source& pdf, int page);

/// How many pages it has, by pdfinfo. Throws as pdf_as_svg, and for more pages than kMostPdfPages.
int pages_of_pdf(const Source& pdf);

inline constexpr int kMostPdfPages = 1'000'000;

/// What `pdfimages -list` says of a page.
struct PdfPictures {
    std::size_t listed = 0;  ///< with masks
    std::size_t count = 0;   ///< without
    double largest = 0;      ///< square points that the largest covers
};
PdfPictures pictures_told(std::string_view pdfimages);

/// The number of pages in what pdfinfo writes; nothing: it tells none, or none that may be.
std::optional<int> pages_told(std::string_view pdfinfo);

}  // namespace tactics
