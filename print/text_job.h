// SPDX-License-Identifier: Apache-2.0
// The common part of machines that take lines of braille cells as text.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "print/cell_rows.h"
#include "tactics/page.h"

namespace tactics {

struct TextJob {
    std::string begin;                  ///< sets the machine up
    std::string line_end = "\r\n";      ///< between two lines
    std::string page_end = "\r\n\f";    ///< after the last line of a page
    std::string blank_page_end = "\f";  ///< of a page without lines
    std::string full_page_end = {};     ///< after the last of `most_lines`, in place of page_end
    std::size_t most_lines = 0;         ///< 0: the machine ends no page on its own
    std::string end;
    std::string (*letter)(std::uint8_t cell) = nullptr;
};

/// All pages in sequence, without empty cells at the end of a line and empty lines at the end of a page.
std::string text_job(std::span<const Page> pages, const TextJob& job);

/// The letter of a 6-dot cell in North American Braille Computer Code.
std::string nabcc_letter(std::uint8_t cell);

/// The letter of a cell in Unicode (Braille Patterns), as UTF-8.
std::string unicode_letter(std::uint8_t cell);

/// How many cells and lines of the page's cell size fit on a sheet of that size, from the machine's first dot.
int cells_across(const Page& page);
int lines_down(const Page& page);

}  // namespace tactics
