// SPDX-License-Identifier: Apache-2.0
// The pages of a PDF that we wrote. Each carries its SVG as an associated file (ISO 32000-2, 14.13), so that it can be converted
// again as exactly as the SVG. Only a file that is as it was written counts: other programs change a page and keep what was
// associated with it. That is a check against changes, no proof of who wrote the file; its SVG is read as any other is.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tactics {

/// How the dictionary of such an SVG begins.
inline constexpr std::string_view kOwnPageEntries = "/Type /EmbeddedFile /Subtype /image#2Fsvg+xml /Filter /FlateDecode ";

/// So many bytes from the end of a file tell whether it may be a PDF of ours.
inline constexpr std::size_t kOwnPdfEnd = 400;
bool may_be_own_pdf(std::string_view end);

/// The file identifier (ISO 32000-1, 14.4), 32 hexadecimal digits: our name, and sum and length of what stands before the
/// cross-reference table.
std::string own_pdf_id(std::string_view before_table);

/// The SVG of each page, in zlib's format (inflated() of gzip.h unpacks it), as parts of `pdf`; nothing: it is of another maker,
/// or was changed.
std::optional<std::vector<std::string_view>> own_pdf_pages(std::string_view pdf);

}  // namespace tactics
