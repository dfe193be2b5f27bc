// SPDX-License-Identifier: Apache-2.0
// How much one drawing tells of another, wherever, however large and which way up each is drawn: the mutual information of where
// their lines are near (section 4 of K. Moustakas, "Handling haptics as a stand-alone medium", WSCG 2013), over the places that
// fit best. For finding a drawing that exists already.
#pragma once

#include <cstdint>
#include <vector>

#include "tactics/information/grid.h"

namespace tactics {

/// A drawing as it is compared: how near the next line is, on a square of cells in which the box round its lines stands in the
/// middle. A few kilobytes, however large the drawing is.
struct Look {
    std::vector<std::uint8_t> nearness;  ///< row by row: 0 where lines are far, kNearest on a line
    int wide = 0, high = 0;              ///< cells of the box, in the middle
};
inline constexpr int kLookSide = 64;         ///< cells; ours: a figure of A4 at 4 mm a cell, of which a finger covers ten
inline constexpr std::uint8_t kNearest = 5;  ///< on a line, then within 1, 2, 4 and 7 cells

/// Of black (1) on white (0). Throws Error(failed): nothing is drawn. `name` is the file's, for messages.
Look look_of(const LevelGrid& drawn, std::string_view name);

/// How the second is moved so that it tells most of the first.
struct Alignment {
    int quarter_turns = 0;  ///< clockwise
    bool mirrored = false;  ///< left to right, before it is turned
    double scale = 1;       ///< besides that of its box
    bool operator==(const Alignment&) const = default;
};

struct Likeness {
    double share = 0;   ///< I / H of the first, over its box: 1 for the same drawing, near 0 for one that tells nothing of it
    double mutual = 0;  ///< I, bits a cell
    Alignment alignment;
};

/// Tries scales within a quarter, moves within an eighth of the square, and, if `any_way_up`, turns by quarters and mirror
/// images.
Likeness likeness(const Look& first, const Look& second, bool any_way_up);

}  // namespace tactics
