// SPDX-License-Identifier: Apache-2.0
// A label set in print and braille as one block, before it has its place.
#pragma once

#include <string>
#include <vector>

#include "tactics/layout/sheet.h"
#include "tactics/page.h"

namespace tactics {

/// Print above braille, left-aligned, from (0, 0) at the top left.
struct LabelBlock {
    double width = 0;   ///< mm; of print at most as wide as this
    double height = 0;  ///< mm
    std::vector<PrintLine> print;
    std::vector<BrailleLine> braille;
};

/// Throws Error(usage) as to_braille does.
LabelBlock set_label(const std::string& text, const Sheet& sheet);

/// Its lines set those words, which become the page's.
void say(LabelBlock& block, Page& page, PageWords words);

/// The block where `label` wants it, its `at` being on the page; pushed back onto paper of that size where it would leave
/// it. Throws Error(usage) if it is wider than the paper.
LabelBlock placed(LabelBlock block, const Label& label, Point at, const CellSize& cell, double page_width, double page_height);

}  // namespace tactics
