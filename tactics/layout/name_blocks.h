// SPDX-License-Identifier: Apache-2.0
// The words of names, and the cells that stand for them, set but not yet placed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tactics/drawing.h"
#include "tactics/layout/label.h"
#include "tactics/layout/sheet.h"
#include "tactics/page.h"

namespace tactics {

/// Line by line.
void sort_as_read(std::vector<PageName>& names);

double dots_width(std::size_t cells, const Page& page);  ///< mm, of one line

LabelBlock block_of(const std::vector<std::uint8_t>& cells, const Page& page);

/// Throws Error at the name's origin as set_label does.
LabelBlock block_of(const Name& name, const Sheet& sheet);

/// The words of a block of one line of braille in two lines, in three and so on up to `most`, broken between words, each as
/// narrow as it can be. None that would be no narrower than the one before it.
std::vector<LabelBlock> folded(const LabelBlock& line, std::size_t most, const Page& page);

}  // namespace tactics
