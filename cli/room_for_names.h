// How large a drawing may be so that the names around it have room.
#pragma once

#include <functional>
#include <optional>

#include "tactics/page.h"

namespace tactics {

/// Of some widths up to `widest`, the one where names stand best: at their places before lead lines, those before two letters
/// and a key, and the drawing as large as that allows. `draw` makes the drawing for a sheet of that width. Nothing: no width has room.
std::optional<double> width_with_room(const Sheet& sheet, double widest, const std::function<Drawing(const Sheet& sheet)>& draw);

}  // namespace tactics
