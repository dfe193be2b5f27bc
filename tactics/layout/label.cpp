// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/label.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "tactics/braille/braille.h"
#include "tactics/error.h"
#include "tactics/layout/sheet.h"
#include "tactics/layout/title.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr double kLabelPrintSize = 3.53;  // mm, 10 pt: read by sighted people at reading distance
constexpr double kPrintToBraille =
    1.5;  // mm from print to braille: they are for different senses, but dots must stay clear of ink

}  // namespace

LabelBlock set_label(const std::string& text, const Sheet& sheet) {
    LabelBlock block;
    const std::string line = to_line(text);
    if (line.empty()) return block;
    if (sheet.print_title) {
        block.print.push_back({{0, kAscent * kLabelPrintSize}, kLabelPrintSize, line});
        block.width = print_width(line) * kLabelPrintSize;
        block.height = (kAscent + kDescent) * kLabelPrintSize;
    }
    if (sheet.braille_table.empty()) return block;
    const CellSize& cell = sheet.cell;
    const double dot = cell.dot;
    BrailleLine braille{{dot / 2, dot / 2}, to_braille(line, sheet.braille_table, "the words \"" + line + "\"")};
    if (braille.cells.empty()) return block;
    if (block.height > 0) block.height += kPrintToBraille;
    braille.first_dot.y += block.height;
    const bool eight_dots = *std::max_element(braille.cells.begin(), braille.cells.end()) > 0x3F;
    block.height += (eight_dots ? 3 : 2) * cell.dot_pitch + dot;
    const double cells = static_cast<double>(braille.cells.size());
    block.width = std::max(block.width, (cells - 1) * cell.cell_pitch + cell.dot_pitch + dot);
    block.braille.push_back(std::move(braille));
    return block;
}

void say(LabelBlock& block, Page& page, PageWords words) {
    const int number = static_cast<int>(page.words.size());
    page.words.push_back(std::move(words));
    for (PrintLine& line : block.print) line.words = number;
    for (BrailleLine& line : block.braille) line.words = number;
}

LabelBlock placed(LabelBlock block, const Label& label, Point at, const CellSize& cell, double page_width, double page_height) {
    if (block.width > page_width || block.height > page_height)
        throw Error(Fault::usage, "", phrase("the words \"{0}\" are larger than the paper; take larger paper", label.text));
    const double left = std::clamp(at.x - label.across * block.width, 0.0, page_width - block.width);
    const double top = std::clamp(at.y - label.down * block.height, 0.0, page_height - block.height);
    for (PrintLine& line : block.print) {
        const double slack = block.width - print_width(line.text) * line.size;
        line.baseline.x += left + label.across * slack;
        line.baseline.y += top;
    }
    for (BrailleLine& line : block.braille) {
        const double dots = static_cast<double>(line.cells.size() - 1) * cell.cell_pitch + cell.dot_pitch;
        line.first_dot.x += left + label.across * std::max(0.0, block.width - dots - 2 * line.first_dot.x);
        line.first_dot.y += top;
    }
    return block;
}

void put_on(Page& page, LabelBlock block, Point corner) {
    for (PrintLine& line : block.print) {
        line.baseline.x += corner.x;
        line.baseline.y += corner.y;
    }
    for (BrailleLine& line : block.braille) {
        line.first_dot.x += corner.x;
        line.first_dot.y += corner.y;
    }
    std::move(block.print.begin(), block.print.end(), std::back_inserter(page.print));
    std::move(block.braille.begin(), block.braille.end(), std::back_inserter(page.braille));
}

}  // namespace tactics
