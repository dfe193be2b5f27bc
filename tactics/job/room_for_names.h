// SPDX-License-Identifier: Apache-2.0
// The largest size of a drawing that leaves room for the names around it.
#pragma once

#include <functional>
#include <optional>

#include "tactics/layout/place.h"
#include "tactics/page.h"

namespace tactics {

struct RoomFound {
    double width = 0;
    std::size_t left_out = 0;  ///< optional names without room
};

/// Makes the drawing for its place on a sheet, and rearranges the sheet if the drawing turns out to have another shape.
using DrawOnSheet = std::function<Drawing(const Sheet& sheet, Arrangement& arrangement)>;

/// Tries some widths up to `widest` and returns the one where names are placed best: names at their places are better than lead
/// lines, these better than two letters and a key, and these better than none; then the larger drawing, whose shape is `aspect`
/// (width / height), is better. Nothing: no width has room.
std::optional<RoomFound> width_with_room(const Sheet& sheet, double widest, double aspect, const DrawOnSheet& draw);

}  // namespace tactics
