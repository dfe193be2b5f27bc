// SPDX-License-Identifier: Apache-2.0
// Dots at equal distances in both directions, as embossers use for pictures.
#pragma once

#include <string_view>

#include "print/format.h"

namespace tactics {

/// Raster and braille for a pitch of "1.6", "2.0" or "2.5" mm.
DotSetting equal_dots(std::string_view pitch, Point first);

/// For a display with that many pins at that pitch (mm): its border is half a pitch wide, and cells take three pins by four.
DotSetting display_pins(double pitch, int columns, int rows);

}  // namespace tactics
