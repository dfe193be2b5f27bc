// SPDX-License-Identifier: Apache-2.0
// A tile of levels whose ground rises and falls: what a guess lacks, by asymmetric numeral systems with a table for each
// steepness.
//
// J. Duda, "Asymmetric numeral systems" (arXiv:1311.2540). A residual is folded to a whole number; up to 15 it is a symbol, above
// that a symbol is its length in bits and its second bit, and its other bits follow as they are. The steepness is that of the
// levels around; of 40 kinds of it, those with few levels share a table. Two coders take turns, so that one need not wait for the
// other.
#pragma once

#include <string>
#include <string_view>

#include "tactics/coding/tile_view.h"

namespace tactics {

/// Levels are at most `top`.
std::string slope_bytes(const TileView<const Level>& tile, int top);
/// False: the bytes are none of slope_bytes. All levels are written, or some, none above `top`.
bool read_slope(std::string_view bytes, const TileView<Level>& tile, int top);

}  // namespace tactics
