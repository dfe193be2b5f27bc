// SPDX-License-Identifier: Apache-2.0
// Two strokes that are one sign.
#pragma once

#include <vector>

#include "tactics/lettering/ink.h"

namespace tactics {

/// Puts the two strokes of each equals sign together, so that it stands in line with letters: as long as each other, one above
/// the other, beside a letter that is as high as both. Two samples of a legend, each beside a word of its own, are none.
/// Says which of the pieces are signs then.
std::vector<bool> join_equals_signs(std::vector<InkPiece>& pieces);

}  // namespace tactics
