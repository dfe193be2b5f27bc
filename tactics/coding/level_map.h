// SPDX-License-Identifier: Apache-2.0
// Maps of heights in the container: nothing of them is lost, and any part of a map can be read without the rest.
//
// Facts of the kind "heights" (46 bytes), then a part for each tile, row by row:
//     0   4   columns        4   4   rows
//     8   8   pitch, mm     16   8   height of black, and of level 0, mm     24   8   height of white, mm
//    32   8   from one level to the next, mm (IEEE 754 doubles, all of them)
//    40   2   highest level that there may be, 1 to 65535; it is not above white
//    42   2   side of a tile, 1 to 4096 levels; those at the right and lower edge are smaller
//    44   1   cross-section of its lines: 0 nothing told, 1 round, 2 flat
//    45   1   0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/coding/container.h"
#include "tactics/coding/tile_view.h"

namespace tactics {

struct LevelMap {
    int columns = 0, rows = 0;
    double pitch = 0;                ///< mm
    double low = 0, high = 0;        ///< mm, of black, which is level 0, and of white; high is over low
    double rise = 0;                 ///< mm from one level to the next
    int top = 65535;                 ///< the highest level that there may be, 1 to 65535; not above `high`
    std::string profile = {};        ///< "", "round", "flat"
    std::vector<Level> levels = {};  ///< row by row from the top
};

/// The same map with the fewest levels that tell all that it holds: samples of 16 bits that come from 8 or from 12 are multiples
/// of 257 or of 16.
LevelMap with_fewest_levels(LevelMap map);

/// Of a map whose sides are 1 to 200,000 levels.
std::string encode_levels(const LevelMap& map);

/// A rectangle of levels of a map.
struct LevelWindow {
    int left = 0, top = 0, columns = 0, rows = 0;
};

/// The map without its levels. Throws Error(failed) if it is no map, or if a fact is none that there can be.
LevelMap map_facts(const Container& container);
/// The levels of a window, which lies within the map; of the tiles those only that it meets are read. The map that is given has
/// the window's size. At most `most` levels: more are refused before they get memory. Throws Error(failed).
LevelMap decode_levels(const Container& container, const LevelWindow& window, long long most);
/// The whole map.
LevelMap decode_levels(const Container& container, long long most);

}  // namespace tactics
