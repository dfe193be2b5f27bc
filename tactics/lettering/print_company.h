// SPDX-License-Identifier: Apache-2.0
// What stands beside print as print does.
#pragma once

#include <cstddef>
#include <vector>

#include "tactics/lettering/known_print.h"
#include "tactics/lettering/read_line.h"

namespace tactics {

/// Nothing touches it or is right beside it, but for specks of noise.
bool has_room_around(const Image& grey, const LetteringLine& line);

/// By its foot, its middle or one of its ends, and not far off.
bool in_line_with_print(const LetteringLine& line, const KnownPrint& known);

/// One of the figures of an axis, which are in even steps along a row or column: three, one of which is known print, or four.
bool is_on_scale(std::size_t which, const std::vector<ReadLine>& lines);

/// One of three or more figures of an upright axis that climb, each letter by itself; one of them at least can only be a letter,
/// as large as known print if there is any.
bool is_climbing_figure(std::size_t which, const std::vector<ReadLine>& lines, const KnownPrint& known);

}  // namespace tactics
