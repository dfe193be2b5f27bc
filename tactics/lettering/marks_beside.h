// SPDX-License-Identifier: Apache-2.0
// Marks that stand in line with words and are no letters: the swatch of a legend, the dot of a node.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/lettering/ink.h"

namespace tactics {

/// The letters of a line, by numbers, cut where a mark stands; each mark is a part of its own. `boxes` as seen by the reader,
/// from the left to the right.
std::vector<std::vector<std::size_t>> parts_at_marks(const std::vector<InkPiece>& pieces, const std::vector<PixelBox>& boxes,
                                                     const std::vector<std::size_t>& letters);

/// The dot of a node, as high as the middle of the letters and larger than a point: `box` as seen by the reader, as `line` is.
bool is_node(const InkPiece& piece, const PixelBox& box, const PixelBox& line);

}  // namespace tactics
