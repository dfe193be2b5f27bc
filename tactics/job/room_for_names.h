// SPDX-License-Identifier: Apache-2.0
// The place of a drawing on its sheet that leaves room for the names in it and beside it.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "tactics/layout/place.h"
#include "tactics/page.h"

namespace tactics {

/// A drawing of that width, mm. Names may lie outside of it.
struct SizedDrawing {
    std::function<std::vector<Name>(double width)> names;
    std::function<Drawing(double width)> draw;  ///< with these names
};

struct RoomFound {
    Arrangement arrangement;
    std::size_t left_out = 0;  ///< optional names without room
};

/// Turns the sheet, moves the drawing and tries some widths: names at their places are better than lead lines, these better than
/// two letters and a key, and these better than none; then the larger drawing, whose shape is `aspect` (width / height), is
/// better. The first width that is drawn is probably the best. Nothing: no width has room.
std::optional<RoomFound> place_with_room(const Sheet& sheet, double aspect, const SizedDrawing& drawing);

/// Draws names that lie far outside of a drawing of that size nearer to it, in rows as far from each other as braille needs, mm.
void draw_near(std::vector<Name>& names, double width, double height);

}  // namespace tactics
