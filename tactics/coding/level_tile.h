// SPDX-License-Identifier: Apache-2.0
// A tile of levels as bytes, in whichever of four ways takes the fewest of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tactics/coding/tile_view.h"

namespace tactics {

/// The first byte of a tile.
enum class TileWay : unsigned char {
    plain = 0,  ///< each level in as many bits as the highest needs, the first in the lowest
    even = 1,   ///< one level, of two bytes
    slope = 2,  ///< slope_tile.h
    drawn = 3,  ///< drawn_tile.h
};

/// How a map, or a tile of one, is looked at: some rows are tried in both ways.
TileWay way_of(const TileView<const Level>& tile, int top);

/// Levels are at most `top`, which is 1 to 65535. A tile is at least one level. `known`: its way_of, for who knows it.
std::string tile_bytes(const TileView<const Level>& tile, int top, std::optional<TileWay> known = {});
/// False: the bytes are none of tile_bytes of such a tile. All levels are written, or some, none above `top`.
bool read_tile(std::string_view bytes, const TileView<Level>& tile, int top);

}  // namespace tactics
