// SPDX-License-Identifier: Apache-2.0
// Thin lines on a slope that come in pieces.
#pragma once

#include <vector>

#include "tactics/lettering/ink.h"

namespace tactics {

/// Takes out what a thin line leaves that is nearly level or upright: where it steps from one row or column of pixels to the
/// next, both are pale, and its parts would stand as bars beside the letters that it passes. Four of them in a row are such a
/// line.
void drop_stroke_steps(std::vector<InkPiece>& pieces);

}  // namespace tactics
