// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/name_blocks.h"

#include <algorithm>
#include <cmath>

#include "tactics/error.h"
#include "tactics/layout/wrapped.h"

namespace tactics {

namespace {

bool reads_before(const PageName& a, const PageName& b) {
    constexpr double kLine = 10;  // mm: about one line of braille
    const double row_a = std::floor(a.place.top / kLine), row_b = std::floor(b.place.top / kLine);
    return row_a != row_b ? row_a < row_b : a.place.left < b.place.left;
}

std::size_t longest_word(const std::vector<std::uint8_t>& cells) {
    std::size_t longest = 0, length = 0;
    for (const std::uint8_t cell : cells) {
        length = cell == 0 ? 0 : length + 1;
        longest = std::max(longest, length);
    }
    return longest;
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

std::vector<LabelBlock> folded(const LabelBlock& line, std::size_t most, const Page& page) {
    std::vector<LabelBlock> blocks;
    if (line.braille.size() != 1 || !line.print.empty()) return blocks;
    const std::vector<std::uint8_t>& cells = line.braille.front().cells;
    const std::size_t words = words_in(cells), narrowest = longest_word(cells);
    const auto in_lines = [&](std::size_t width) { return wrapped(cells, width, WordDivision()); };  // no word is longer
    std::size_t before = cells.size();
    for (std::size_t lines = 2; lines <= std::min(most, words) && narrowest < before; ++lines) {
        std::size_t width = narrowest;
        while (in_lines(width).size() > lines) ++width;
        if (width >= before) continue;
        before = width;
        LabelBlock block;
        block.width = dots_width(width, page);
        for (std::vector<std::uint8_t>& part : in_lines(width)) {
            const double down = static_cast<double>(block.braille.size()) * page.cell.line_pitch;
            const Point first = line.braille.front().first_dot;
            block.braille.push_back({{first.x, first.y + down}, std::move(part)});
            block.height = line.height + down;
        }
        blocks.push_back(std::move(block));
    }
    return blocks;
}

}  // namespace tactics
