// SPDX-License-Identifier: Apache-2.0
#include "print/text_job.h"

#include <cmath>

#include "tactics/braille/braille.h"
#include "tactics/text/utf8.h"

namespace tactics {

std::string text_job(std::span<const Page> pages, const TextJob& job) {
    std::string bytes = job.begin;
    for (const Page& page : pages) {
        const CellRows rows = cell_rows(page);
        const std::size_t end = lines_used(rows);
        for (std::size_t i = 0; i < end; ++i) {
            if (i > 0) bytes += job.line_end;
            for (const std::uint8_t cell : without_end(rows.line(i))) bytes += job.letter(cell);
        }
        bytes += end == 0 ? job.blank_page_end : job.most_lines > 0 && end >= job.most_lines ? job.full_page_end : job.page_end;
    }
    return bytes + job.end;
}

std::string nabcc_letter(std::uint8_t cell) { return {brf_letter(cell)}; }

std::string unicode_letter(std::uint8_t cell) {
    std::string letter;
    append_letter(letter, 0x2800u + cell);
    return letter;
}

// The last cell needs its dots only, not the gap behind it.
int cells_across(const Page& page) {
    const double first = page.bed ? page.bed->first.x : 0;
    return static_cast<int>(std::floor((page.width - 2 * first - page.cell.dot_pitch) / page.cell.cell_pitch + 1 + 1e-6));
}

int lines_down(const Page& page) {
    const double first = page.bed ? page.bed->first.y : 0;
    return static_cast<int>(std::floor((page.height - 2 * first - 2 * page.cell.dot_pitch) / page.cell.line_pitch + 1 + 1e-6));
}

}  // namespace tactics
