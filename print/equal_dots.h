// SPDX-License-Identifier: Apache-2.0
// Dots that are equally far apart in both directions, as embossers draw pictures.
#pragma once

#include <string_view>

#include "print/format.h"

namespace tactics {

/// Raster and braille for a pitch of "1.6", "2.0" or "2.5" mm.
DotSetting equal_dots(std::string_view pitch, Point first);

/// Of a display of so many pins, that pitch (mm) apart: half of it is beside the outermost, and cells take three pins by four.
DotSetting display_pins(double pitch, int columns, int rows);

}  // namespace tactics
