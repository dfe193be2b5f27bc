// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/name_blocks.h"

#include <algorithm>
#include <cmath>

#include "tactics/error.h"

namespace tactics {

namespace {

bool reads_before(const PageName& a, const PageName& b) {
    constexpr double kLine = 10;  // mm: about one line of braille
    const double row_a = std::floor(a.place.top / kLine), row_b = std::floor(b.place.top / kLine);
    return row_a != row_b ? row_a < row_b : a.place.left < b.place.left;
}

}  // namespace

void sort_as_read(std::vector<PageName>& names) { std::stable_sort(names.begin(), names.end(), reads_before); }

double dots_width(std::size_t cells, const Page& page) {
    return (static_cast<double>(cells) - 1) * page.cell.cell_pitch + page.cell.dot_pitch + page.braille_dot;
}

LabelBlock block_of(const std::vector<std::uint8_t>& cells, const Page& page) {
    LabelBlock block;
    block.width = dots_width(cells.size(), page);
    block.height = 2 * page.cell.dot_pitch + page.braille_dot;
    block.braille.push_back({{page.braille_dot / 2, page.braille_dot / 2}, cells});
    return block;
}

LabelBlock block_of(const Name& name, const Sheet& sheet) {
    Sheet quiet = sheet;
    quiet.print_title = sheet.braille_table.empty();  // print between the lines of a drawing is felt as lines
    try {
        return set_label(name.text, quiet);
    } catch (const Error& error) {
        if (name.origin.empty()) throw;
        throw Error(error.fault(), name.origin, error.what());
    }
}

}  // namespace tactics
