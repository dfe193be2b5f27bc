// SPDX-License-Identifier: Apache-2.0
// How large a drawing may be so that the names around it have room.
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

/// Makes the drawing for its place on a sheet, which is arranged anew if the drawing turns out to have another shape.
using DrawOnSheet = std::function<Drawing(const Sheet& sheet, Arrangement& arrangement)>;

/// Of some widths up to `widest`, the one where names stand best: at their places before lead lines, those before two letters
/// and a key, those before none, and the drawing, whose shape is `aspect` (width / height), as large as that allows. Nothing: no
/// width has room.
std::optional<RoomFound> width_with_room(const Sheet& sheet, double widest, double aspect, const DrawOnSheet& draw);

}  // namespace tactics
