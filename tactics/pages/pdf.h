// Pages of PDF files, through a program that draws them as SVG.
#pragma once

#include <string>

namespace tactics {

/// The first page of a PDF file as SVG, by pdftocairo (of poppler-utils); more pages show as further `page` elements. Throws
/// Error(failed): it is not installed, cannot read the file, or takes over a minute.
std::string pdf_as_svg(const std::string& path);

}  // namespace tactics
