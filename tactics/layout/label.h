// SPDX-License-Identifier: Apache-2.0
// A label in print and braille as one block, before it is placed.
#pragma once

#include <string>
#include <vector>

#include "tactics/layout/sheet.h"
#include "tactics/page.h"

namespace tactics {

/// Print above braille, left-aligned, from (0, 0) at the top left.
struct LabelBlock {
    double width = 0;   ///< mm; upper bound of the width of print
    double height = 0;  ///< mm
    std::vector<PrintLine> print;
    std::vector<BrailleLine> braille;
};

/// Throws Error(usage) as to_braille does.
LabelBlock set_label(const std::string& text, const Sheet& sheet);

/// The block's lines set those words, which are added to the page.
void say(LabelBlock& block, Page& page, PageWords words);

/// Places the block as `label` asks, with `at` in page coordinates; pushes it back onto paper of that size if it would leave it.
/// Throws Error(usage) if it is wider than the paper.
LabelBlock placed(LabelBlock block, const Label& label, Point at, const CellSize& cell, double page_width, double page_height);

/// Its lines of print and braille, with its corner there.
void put_on(Page& page, LabelBlock block, Point corner);

}  // namespace tactics
