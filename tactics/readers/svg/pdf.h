// SPDX-License-Identifier: Apache-2.0
// Pages of PDF files, through programs of poppler-utils that read them.
#pragma once

#include <string>

namespace tactics {

/// The first page of a PDF file as SVG, by pdftocairo; more pages show as further `page` elements. Throws
/// Error(failed): it is not installed, cannot read the file, or takes over a minute.
std::string pdf_as_svg(const std::string& path);

/// A page, from 1, as a PNG in colour, 150 dots per inch: no medium shows more. Throws as pdf_as_svg, also for a
/// page that there is not (pages_of_pdf).
std::string pdf_page_as_png(const std::string& path, int page);

/// How many pages it has, by pdfinfo. Throws as pdf_as_svg.
int pages_of_pdf(const std::string& path);

}  // namespace tactics
