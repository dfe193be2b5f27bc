// SPDX-License-Identifier: Apache-2.0
// Parts of thin lines and rings that come in pieces.
#pragma once

#include <vector>

#include "tactics/image.h"
#include "tactics/lettering/ink.h"

namespace tactics {

/// Takes out the bars and bent bands among `pieces`, the ink at `level`, that hang together with a drawn line where fainter ink
/// counts, too. A thin ring is dark where it runs along the rows or columns of pixels and pale between them: its parts would
/// stand as letters beside the one that it has in it.
void drop_stroke_parts(const Image& grey, int level, bool light, std::vector<InkPiece>& pieces);

}  // namespace tactics
