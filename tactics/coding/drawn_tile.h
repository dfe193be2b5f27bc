// SPDX-License-Identifier: Apache-2.0
// A tile of levels that are lines, letters, plates: what stood where its neighbours were the same, stands here.
//
// Eleven neighbours, mixed to a number, find the level that followed them last, and the six nearest another; a decision each says
// whether it is that. Only what is neither is told as what a guess lacks. All by adaptive binary coding (binary_coder.h).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "tactics/coding/tile_view.h"

namespace tactics {

/// Levels are at most `top`. Who wants to know only whether they are fewer than `enough` gets at least so many if not.
std::string drawn_bytes(const TileView<const Level>& tile, int top, std::size_t enough = SIZE_MAX);
/// False: the bytes are none of drawn_bytes. All levels are written, or some, none above `top`.
bool read_drawn(std::string_view bytes, const TileView<Level>& tile, int top);

}  // namespace tactics
